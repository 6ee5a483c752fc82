// The particles of a run over time: packed for drawing (see server/page/README.md), and as the run
// wrote them.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "db/result_file.hpp"
#include "server/http/handlers/handlers.hpp"
#include "server/http/handlers/parameters.hpp"
#include "server/http/site.hpp"
#include "server/layers/compare_sections.hpp"
#include "server/operate/problem.hpp"
#include "solver/section/frame.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

constexpr int most_frames = 100;
/// Of one answer: 32 MB packed.
constexpr std::size_t most_particles = 5'000'000;
constexpr float steps = 65'535;

struct Range {
  float least = 0, most = 0;

  void hold(float value) {
    if (!std::isfinite(value)) return;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  std::uint16_t packed(float value) const {
    if (!(most > least) || !std::isfinite(value)) return 0;
    return static_cast<std::uint16_t>(std::lround((value - least) / (most - least) * steps));
  }
  json document() const { return {least, most}; }
};

Range range_of(const std::vector<Frame>& frames, std::vector<float> Frame::*values) {
  Range range;
  bool first = true;
  for (const Frame& frame : frames) {
    for (const float value : frame.*values) {
      if (first && std::isfinite(value)) {
        range = {value, value};
        first = false;
      }
      range.hold(value);
    }
  }
  return range;
}

/// What is drawn, and the arrays of a frame that it is made of.
struct Drawn {
  std::string_view name;
  std::vector<std::string> fields;
  std::string unit;
};

Drawn drawn_of(const Call& call) {
  const std::string name = call.parameter("field").value_or("plastic_strain");
  if (name == "speed") return {"speed", {"velocity_x", "velocity_z"}, "m/s"};
  if (name == "material") return {"material", {}, "1"};
  if (name == "plastic_strain") return {"plastic_strain", {"plastic_strain"}, "1"};
  throw Problem(Failure::invalid_parameter,
                "field is '" + name + "': give plastic_strain, speed or material");
}

/// Puts what is drawn where plastic strain stands.
void bring_together(const Drawn& drawn, Frame& frame) {
  if (drawn.name == "plastic_strain") return;
  frame.plastic_strain.resize(frame.x.size());
  for (std::size_t i = 0; i < frame.x.size(); ++i) {
    frame.plastic_strain[i] = drawn.name == "speed"
                                  ? std::hypot(frame.velocity_x[i], frame.velocity_z[i])
                                  : static_cast<float>(frame.material[i]);
  }
}

void append(std::string& bytes, const std::vector<float>& values, const Range& range) {
  for (const float value : values) {
    const std::uint16_t packed = range.packed(value);
    bytes += static_cast<char>(packed & 0xff);
    bytes += static_cast<char>(packed >> 8);
  }
}

/// The length of the head (4 bytes, the least first), the head as JSON, then for each frame x, z
/// and the value of every particle, 16 bits each (the least first) over the ranges that the head
/// gives.
std::string packed(const std::vector<Frame>& frames, json head) {
  const Range x = range_of(frames, &Frame::x), z = range_of(frames, &Frame::z),
              value = range_of(frames, &Frame::plastic_strain);
  head["x_m"] = x.document();
  head["z_m"] = z.document();
  head["value"] = value.document();
  std::size_t particles = 0;
  for (const Frame& frame : frames) {
    head["particles"].push_back(frame.x.size());
    particles += frame.x.size();
  }
  std::string text = head.dump();
  text.append((4 - text.size() % 4) % 4, ' ');  // what follows stands at a multiple of 4
  std::string bytes;
  bytes.reserve(4 + text.size() + particles * 6);
  for (int shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>((text.size() >> shift) & 0xff);
  }
  bytes += text;
  for (const Frame& frame : frames) {
    append(bytes, frame.x, x);
    append(bytes, frame.z, z);
    append(bytes, frame.plastic_strain, value);
  }
  return bytes;
}

std::string why_no_fields(const db::SectionRecord& section) {
  const std::string of = "section '" + section.name + "' has no fields.h5: ";
  if (section.run.empty()) {
    return of + "it is " + db::to_string(section.state) + " and was not run" +
           (section.reason.empty() ? "" : " (" + section.reason + ")");
  }
  if (section.state == db::SectionState::running) return of + "its run is not over";
  if (section.member) return of + "it is a member of an ensemble, of which none are kept";
  return of + "run " + section.run + " left none, or it was removed";
}

std::filesystem::path fields_file(const Service& service, const db::SectionRecord& section) {
  const auto file = service.data.run(section.run) / "fields.h5";
  if (section.run.empty() || !std::filesystem::exists(file)) {
    throw Problem(Failure::no_such_resource, why_no_fields(section));
  }
  return file;
}

db::SectionRecord section_of(const Service& service, const Call& call) {
  return sections_or_problem(service.store, call.captured[0], {call.captured[1]}).front();
}

}  // namespace

Answer get_frames(Site& site, const Call& call) {
  const Drawn drawn = drawn_of(call);
  const auto first = static_cast<std::size_t>(whole_number(call, "first", 0, 0, 1'000'000));
  const auto count = static_cast<std::size_t>(whole_number(call, "count", 20, 1, most_frames));
  const auto file = fields_file(site.service, section_of(site.service, call));
  const db::Turns::Turn turn(site.pages);
  db::FrameWindow window{first, count, most_particles, {"x", "z"}, drawn.name == "material"};
  window.fields.insert(window.fields.end(), drawn.fields.begin(), drawn.fields.end());
  auto part = db::read_frames(file, window);
  for (Frame& frame : part.frames) bring_together(drawn, frame);
  json head = {
      {"field", drawn.name},     {"unit", drawn.unit},          {"first", first},
      {"times_s", part.times_s}, {"materials", part.materials}, {"particles", json::array()}};
  Answer answer;
  answer.type = "application/octet-stream";
  answer.body = packed(part.frames, std::move(head));
  return answer;
}

Answer get_fields(Site& site, const Call& call) {
  const auto section = section_of(site.service, call);
  Answer answer;
  answer.file = fields_file(site.service, section);
  // A run writes its fields once; another try of the section is another run.
  const std::string tag = "\"" + section.run + "-fields\"";
  if (has_already(call, tag)) return not_modified(tag);
  answer.type = "application/x-hdf5";
  answer.headers.emplace_back("ETag", tag);
  answer.headers.emplace_back("Content-Disposition",
                              "attachment; filename=\"" + section.run + "-fields.h5\"");
  return answer;
}

}  // namespace leda::server
