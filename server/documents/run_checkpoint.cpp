#include "server/documents/run_checkpoint.hpp"

#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

#include "server/documents/run_folder.hpp"
#include "server/documents/sha256.hpp"

namespace leda::server {
namespace {

namespace fs = std::filesystem;

std::string read_all(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Every array of a frame, in one fixed order.
template <class F, class Visit>
void for_each_array(F& f, Visit visit) {
  for (auto* array : {&f.x, &f.z, &f.velocity_x, &f.velocity_z, &f.stress_xx, &f.stress_zz,
                      &f.stress_xz, &f.stress_yy, &f.plastic_strain, &f.strength, &f.volume}) {
    visit(*array);
  }
  visit(f.material);
}

bool read_frame(std::istream& in, Frame& frame) {
  std::uint64_t count = 0;
  in.read(reinterpret_cast<char*>(&frame.time_s), sizeof frame.time_s);
  in.read(reinterpret_cast<char*>(&count), sizeof count);
  for_each_array(frame, [&](auto& array) {
    if (!in) return;
    array.resize(count);
    in.read(reinterpret_cast<char*>(array.data()),
            std::streamsize(count * sizeof(typename std::decay_t<decltype(array)>::value_type)));
  });
  return bool(in);
}

}  // namespace

RunCheckpoint::RunCheckpoint(fs::path folder, std::string sha256, std::string version)
    : state_file_(folder / "checkpoint.bin"),
      frames_file_(folder / "frames.bin"),
      sha256_(std::move(sha256)),
      version_(std::move(version)) {}

std::string RunCheckpoint::head(const std::string& state, std::int64_t frames) const {
  return fmt::format("leda checkpoint\ncase {}\nversion {}\nframes {}\nstate {}\n", sha256_,
                     version_, frames, sha256(state));
}

RunCheckpoint::Left RunCheckpoint::read() {
  Left left;
  const std::string bytes = read_all(state_file_);
  std::istringstream lines(bytes);
  std::string line;
  std::int64_t frames = -1;
  for (int i = 0; i < 5 && std::getline(lines, line); ++i) {
    if (line.starts_with("frames ")) std::istringstream(line.substr(7)) >> frames;
  }
  const auto at = lines.tellg();
  if (lines && frames >= 0) left.state = bytes.substr(std::size_t(at));
  if (left.state.empty() || bytes != head(left.state, frames) + left.state) return {};

  std::ifstream in(frames_file_, std::ios::binary);
  for (std::int64_t i = 0; i < frames; ++i) {
    if (!read_frame(in, left.frames.emplace_back())) return {};
  }
  if (frames > 0) fs::resize_file(frames_file_, std::uintmax_t(in.tellg()));
  return left;
}

void RunCheckpoint::add(const Frame& frame) {
  std::ofstream out(frames_file_, std::ios::binary | std::ios::app);
  const std::uint64_t count = frame.x.size();
  out.write(reinterpret_cast<const char*>(&frame.time_s), sizeof frame.time_s);
  out.write(reinterpret_cast<const char*>(&count), sizeof count);
  for_each_array(frame, [&](const auto& array) {
    out.write(reinterpret_cast<const char*>(array.data()),
              std::streamsize(array.size() * sizeof array[0]));
  });
  out.close();
  if (!out) throw std::runtime_error(frames_file_.string() + " could not be written");
}

void RunCheckpoint::keep(const std::string& state, std::int64_t frames) {
  write_whole(state_file_, head(state, frames) + state);
}

void RunCheckpoint::remove() {
  fs::remove(state_file_);
  fs::remove(frames_file_);
}

}  // namespace leda::server
