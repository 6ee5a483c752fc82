#include "server/documents/run_checkpoint.hpp"

#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <type_traits>

#include "server/documents/sha256.hpp"
#include "server/documents/whole_file.hpp"

namespace leda::server {
namespace {

namespace fs = std::filesystem;

constexpr const char* state_name = "checkpoint.bin";
constexpr const char* frames_name = "frames.bin";
constexpr const char* first_line = "leda checkpoint 2";

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

template <class T>
void append(std::string& bytes, const T* values, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

// A frame as bytes: their number, its time, the number of its particles, its arrays.
std::string packed(const Frame& frame) {
  std::string body;
  const std::uint64_t count = frame.x.size();
  append(body, &frame.time_s, 1);
  append(body, &count, 1);
  for_each_array(frame, [&](const auto& array) { append(body, array.data(), array.size()); });
  const std::uint64_t size = body.size();
  std::string bytes;
  append(bytes, &size, 1);
  return bytes + body;
}

// Reads no further than the bytes that are there, whatever the numbers in them say.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  bool take(T* values, std::uint64_t count) {
    if (count > bytes_.size() / sizeof(T)) return false;
    std::memcpy(values, bytes_.data(), count * sizeof(T));
    bytes_.remove_prefix(count * sizeof(T));
    return true;
  }
  std::string_view take(std::uint64_t count) {
    const auto taken = bytes_.substr(0, count);
    bytes_.remove_prefix(taken.size());
    return taken;
  }
  std::size_t left() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
};

bool unpack(std::string_view body, Frame& frame) {
  Unpacker in(body);
  std::uint64_t count = 0;
  bool whole = in.take(&frame.time_s, 1) && in.take(&count, 1) && count <= in.left();
  for_each_array(frame, [&](auto& array) {
    if (!whole) return;
    array.resize(count);
    whole = in.take(array.data(), count);
  });
  return whole && in.left() == 0;
}

// Empty where the bytes are not exactly `count` frames with that chain.
std::vector<Frame> unpack_all(std::string_view bytes, std::int64_t count,
                              const std::string& chain) {
  std::vector<Frame> frames;
  std::string found;
  Unpacker in(bytes);
  for (std::int64_t i = 0; i < count; ++i) {
    std::uint64_t size = 0;
    if (!in.take(&size, 1) || size > in.left()) return {};
    const std::string_view body = in.take(size);
    found = sha256(found + std::string(body));
    if (!unpack(body, frames.emplace_back())) return {};
  }
  if (in.left() > 0 || found != chain) return {};
  return frames;
}

// The rest of the line that begins with a word.
std::string value_of(const std::string& word, std::istream& lines) {
  std::string line;
  if (!std::getline(lines, line) || !line.starts_with(word + " ")) return "";
  return line.substr(word.size() + 1);
}

}  // namespace

RunCheckpoint::RunCheckpoint(fs::path folder, std::string sha256, std::string version)
    : state_file_(folder / state_name),
      frames_file_(folder / frames_name),
      sha256_(std::move(sha256)),
      version_(std::move(version)) {}

std::string RunCheckpoint::head(const std::string& state, const Frames& frames) const {
  return fmt::format("{}\ncase {}\nversion {}\nframes {} {} {}\nstate {}\n", first_line, sha256_,
                     version_, frames.count, frames.bytes, frames.chain, sha256(state));
}

// Why the bytes of checkpoint.bin are not to be trusted; empty where they are.
std::string RunCheckpoint::mismatch(const std::string& bytes, Frames& frames,
                                    std::size_t& head_bytes) const {
  std::istringstream lines(bytes);
  std::string line;
  if (!std::getline(lines, line) || line != first_line) return "it is damaged or of another form";
  const std::string of_case = value_of("case", lines);
  const std::string version = value_of("version", lines);
  std::istringstream of_frames(value_of("frames", lines));
  of_frames >> frames.count >> frames.bytes >> frames.chain;
  const std::string of_state = value_of("state", lines);
  if (!lines || lines.eof()) return "it is cut off";
  if (of_case != sha256_) return "it is of another case";
  if (version != version_) {
    return fmt::format("leda {} wrote it, this is leda {}", version.substr(0, 40), version_);
  }
  head_bytes = static_cast<std::size_t>(lines.tellg());
  const std::string state = bytes.substr(head_bytes);
  if (state.empty() || bytes != head(state, frames) + state) return "it is damaged or cut off";
  return "";
}

RunCheckpoint::Left RunCheckpoint::read() {
  Left left;
  if (!fs::exists(state_file_)) return left;
  const std::string bytes = read_all(state_file_);
  Frames frames;
  std::size_t head_bytes = 0;
  left.refused = mismatch(bytes, frames, head_bytes);
  if (!left.refused.empty()) return left;
  const std::string packed_frames = read_all(frames_file_);
  if (packed_frames.size() >= frames.bytes) {
    left.frames = unpack_all(std::string_view(packed_frames).substr(0, frames.bytes), frames.count,
                             frames.chain);
  }
  if (static_cast<std::int64_t>(left.frames.size()) != frames.count) {
    left.frames.clear();
    left.refused = "its frames are damaged or cut off";
    return left;
  }
  left.state = bytes.substr(head_bytes);
  frames_ = frames;
  return left;
}

void RunCheckpoint::go_on() {
  if (fs::exists(frames_file_)) fs::resize_file(frames_file_, frames_.bytes);
}

void RunCheckpoint::begin() {
  frames_ = {};
  remove_checkpoint(state_file_.parent_path());
}

void RunCheckpoint::add(const Frame& frame) {
  const std::string bytes = packed(frame);
  append_to_file(frames_file_, bytes);
  ++frames_.count;
  frames_.bytes += bytes.size();
  frames_.chain = sha256(frames_.chain + bytes.substr(sizeof(std::uint64_t)));
}

void RunCheckpoint::keep(const std::string& state, std::int64_t frames) {
  if (frames != frames_.count) {
    throw std::logic_error(fmt::format("{} frames were shown and {} kept", frames, frames_.count));
  }
  if (frames_.count > 0) sync_to_disk(frames_file_);
  write_durably(state_file_, head(state, frames_) + state);
}

void remove_checkpoint(const fs::path& folder) {
  fs::remove(folder / state_name);
  fs::remove(folder / frames_name);
}

bool hand_over_checkpoint(const fs::path& from, const fs::path& to) {
  if (!fs::exists(from / state_name)) return false;
  // The frames are a copy: a try that is thought dead and is not may still add to its own.
  if (fs::exists(from / frames_name)) fs::copy_file(from / frames_name, to / frames_name);
  fs::copy_file(from / state_name, to / state_name);
  return true;
}

}  // namespace leda::server
