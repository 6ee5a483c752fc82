#include "server/documents/result_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "disk/sha256.hpp"
#include "server/documents/json_syntax.hpp"
#include "server/documents/object_reader.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

constexpr std::size_t longest_text = 10'000;
constexpr std::array triggers{"none", "undrained", "toe-cut", "excavation"};

/// One name a number, so that writing, reading and the check for numbers gone wrong agree.
constexpr std::array<std::pair<const char*, double SectionResult::*>, 7> numbers{{
    {"crest_to_crest_retrogression_m", &SectionResult::crest_to_crest_retrogression_m},
    {"runout_m", &SectionResult::runout_m},
    {"runout_from_crest_m", &SectionResult::runout_from_crest_m},
    {"simulated_s", &SectionResult::simulated_s},
    {"run_time_s", &SectionResult::run_time_s},
    {"ns_per_particle_step", &SectionResult::ns_per_particle_step},
    {"numerical_dissipation", &SectionResult::numerical_dissipation},
}};
constexpr std::array<std::pair<const char*, Bound SectionResult::*>, 2> bounds{{
    {"retrogression_is", &SectionResult::retrogression_is},
    {"runout_is", &SectionResult::runout_is},
}};
constexpr std::array<std::pair<const char*, Point SectionResult::*>, 4> points{{
    {"crest_m", &SectionResult::crest},
    {"toe_m", &SectionResult::toe},
    {"backscarp_m", &SectionResult::backscarp},
    {"front_m", &SectionResult::front},
}};
constexpr std::array<std::pair<const char*, double Balances::*>, 3> balances{{
    {"mass", &Balances::mass},
    {"momentum", &Balances::momentum},
    {"energy", &Balances::energy},
}};

/// Sets a number that cannot be written to 0 and says so.
void mend(double& value, const std::string& name, SectionResult& result) {
  if (std::abs(value) <= largest_number) return;
  const std::string what = name + " was " + show(value);
  value = 0;
  result.status = RunStatus::unstable;
  result.reason += (result.reason.empty() ? "" : "; ") + what;
}

SectionResult writable(SectionResult result) {
  for (const auto& [name, member] : numbers) mend(result.*member, name, result);
  for (const auto& [name, member] : points) {
    mend((result.*member).x, std::string(name) + " x", result);
    mend((result.*member).z, std::string(name) + " z", result);
  }
  for (const auto& [name, member] : balances) mend(result.balances.*member, name, result);
  const bool sound = std::ranges::all_of(result.profile_after, [](const Point& p) {
    return std::abs(p.x) <= largest_number && std::abs(p.z) <= largest_number;
  });
  if (!sound) {
    result.profile_after.clear();
    result.status = RunStatus::unstable;
    result.reason += std::string(result.reason.empty() ? "" : "; ") +
                     "the profile after held a value that is not finite";
  }
  mark_lower_bounds(result);
  return result;
}

void read_balances(ObjectReader& reader, SectionResult& result, FaultList& faults) {
  const json* value = reader.require("balances");
  if (!value) return;
  ObjectReader part(*value, reader.at("balances"), faults);
  for (const auto& [name, member] : balances) result.balances.*member = part.number(name);
  part.refuse_unknown();
}

// Absent in results of Leda 0.1.
void read_engine(ObjectReader& reader, SectionResult& result, FaultList& faults) {
  const json* value = reader.find("engine");
  if (!value) return;
  ObjectReader part(*value, reader.at("engine"), faults);
  const std::string precision = part.text("precision");
  const auto known = precision_from(precision);
  if (!known && !precision.empty()) {
    faults.add(part.at("precision"), "is \"" + precision + "\", must be single or double");
  }
  result.engine = Engine{.precision = known.value_or(Precision::double_precision),
                         .instructions = part.text("instructions"),
                         .time_step_factor = part.number("time_step_factor"),
                         .averaged_dilation = part.require("averaged_dilation") &&
                                              part.boolean_or("averaged_dilation", false)};
  part.refuse_unknown();
}

// Absent in results of Leda 0.2 and before: the status and the warnings tell.
void read_bounds(ObjectReader& reader, SectionResult& result, FaultList& faults) {
  for (const auto& [name, member] : bounds) {
    if (!reader.find(name)) {
      mark_lower_bounds(result);
      continue;
    }
    const std::string text = reader.text(name);
    const auto known = bound_from(text);
    if (!known && !text.empty()) {
      faults.add(reader.at(name), "is \"" + text + "\", must be measured or lower-bound");
    }
    result.*member = known.value_or(Bound::lower_bound);
  }
}

void read_warnings(ObjectReader& reader, SectionResult& result, FaultList& faults) {
  const json* value = reader.require("warnings");
  if (!value) return;
  const std::string at = reader.at("warnings");
  if (!value->is_array()) {
    faults.add(at, "is " + kind_of(*value) + ", must be a list of texts");
    return;
  }
  for (std::size_t i = 0; i < value->size(); ++i) {
    result.warnings.push_back(
        read_text((*value)[i], fmt::format("{}/{}", at, i), longest_text, faults));
  }
}

void read_profile(ObjectReader& reader, SectionResult& result, FaultList& faults) {
  const json* value = reader.require("profile_after_m");
  // An unstable run may have no profile.
  if (!value || (value->is_array() && value->empty())) return;
  const std::string at = reader.at("profile_after_m");
  result.profile_after = read_polyline(*value, at, faults);
  for (std::size_t i = 1; i < result.profile_after.size(); ++i) {
    if (result.profile_after[i].x < result.profile_after[i - 1].x) {
      faults.add(fmt::format("{}/{}", at, i), "must not lie left of the point before it");
    }
  }
}

std::int64_t read_count(ObjectReader& reader, const char* key) {
  return reader.require(key) ? reader.integer_or(key, 0) : 0;
}

SectionResult read_members(ObjectReader& reader, FaultList& faults) {
  SectionResult result;
  const std::string status = reader.text("status");
  if (const auto known = run_status_from(status)) {
    result.status = *known;
  } else if (!status.empty()) {
    faults.add(reader.at("status"), "is \"" + status + "\", which is no status of a run");
  }
  result.reason = reader.text_or_empty("reason", longest_text);
  for (const auto& [name, member] : numbers) result.*member = reader.number(name);
  for (const auto& [name, member] : points) {
    if (reader.require(name)) result.*member = reader.optional_point(name).value_or(Point{});
  }
  result.trigger_used = reader.text("trigger_used");
  if (!result.trigger_used.empty() &&
      std::ranges::find(triggers, result.trigger_used) == triggers.end()) {
    faults.add(reader.at("trigger_used"), "is \"" + result.trigger_used +
                                              "\", must be one of none, undrained, toe-cut, "
                                              "excavation");
  }
  // Counts beyond an int are kept out by the check of ranges below.
  const std::int64_t slides = read_count(reader, "slides");
  result.slides = slides <= 1'000'000 ? int(slides) : -1;
  result.steps = read_count(reader, "steps");
  result.particles = read_count(reader, "particles");
  if (reader.find("rate_from_s")) result.rate_from_s = reader.number("rate_from_s");
  read_balances(reader, result, faults);
  read_profile(reader, result, faults);
  read_engine(reader, result, faults);
  read_warnings(reader, result, faults);
  read_bounds(reader, result, faults);
  result.case_sha256 = reader.text("case_sha256");
  if (!result.case_sha256.empty() && !disk::is_sha256(result.case_sha256)) {
    faults.add(reader.at("case_sha256"), "must be 64 lower-case hex digits");
  }
  result.version = reader.text("version");
  reader.refuse_unknown();
  return result;
}

void check_ranges(const SectionResult& result, FaultList& faults) {
  const auto not_negative = [&](const char* key, double v) {
    if (v < 0) faults.add(std::string("/") + key, "is " + show(v) + ", must be at least 0");
  };
  not_negative("crest_to_crest_retrogression_m", result.crest_to_crest_retrogression_m);
  not_negative("simulated_s", result.simulated_s);
  not_negative("run_time_s", result.run_time_s);
  not_negative("ns_per_particle_step", result.ns_per_particle_step);
  not_negative("slides", result.slides);
}

}  // namespace

json to_document(const Engine& engine) {
  return {{"precision", to_string(engine.precision)},
          {"instructions", engine.instructions},
          {"time_step_factor", engine.time_step_factor},
          {"averaged_dilation", engine.averaged_dilation}};
}

json to_document(const SectionResult& as_run) {
  const SectionResult result = writable(as_run);
  json out{{"status", to_string(result.status)},
           {"reason", result.reason},
           {"trigger_used", result.trigger_used},
           {"slides", result.slides},
           {"steps", result.steps},
           {"particles", result.particles},
           {"warnings", result.warnings},
           {"case_sha256", result.case_sha256},
           {"version", result.version},
           {"profile_after_m", json::array()}};
  if (result.rate_from_s) out["rate_from_s"] = *result.rate_from_s;
  if (result.engine) out["engine"] = to_document(*result.engine);
  for (const auto& [name, member] : numbers) out[name] = result.*member;
  for (const auto& [name, member] : bounds) out[name] = to_string(result.*member);
  for (const auto& [name, member] : points) {
    out[name] = {(result.*member).x, (result.*member).z};
  }
  for (const auto& [name, member] : balances) out["balances"][name] = result.balances.*member;
  for (const Point& p : result.profile_after) out["profile_after_m"].push_back({p.x, p.z});
  return out;
}

std::string result_text(const SectionResult& result) {
  // Texts may hold anything, names of a case file for example; broken UTF-8 must not end the run.
  return to_document(result).dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

Parsed<SectionResult> parse_result(std::string_view text) {
  auto parsed = parse_json(text);
  if (!parsed) return {std::nullopt, std::move(parsed.faults)};
  FaultList faults;
  ObjectReader reader(*parsed.value, "", faults);
  SectionResult result = read_members(reader, faults);
  check_ranges(result, faults);
  if (auto found = faults.take(); !found.empty()) return {std::nullopt, std::move(found)};
  return {std::move(result), {}};
}

std::string profile_csv(const Polyline& profile) {
  std::string text = "x_m,z_m\n";
  for (const Point& p : profile) text += fmt::format("{},{}\n", p.x, p.z);
  return text;
}

}  // namespace leda::server
