#include "server/run/run_checkpoint.hpp"

#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>
#include <system_error>

#include "disk/sha256.hpp"
#include "disk/whole_file.hpp"

namespace leda::server {
namespace {

namespace fs = std::filesystem;

constexpr const char* state_name = "checkpoint.bin";
constexpr const char* frames_name = "frames.bin";
constexpr const char* first_line = "leda checkpoint 3";

std::string read_all(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Every array of a frame, in one fixed order.
template <class F, class Visit>
void for_each_array(F& f, Visit visit) {
  for (const FrameField& field : frame_fields) visit(f.*field.values);
  visit(f.material);
}

template <class T>
void append(std::string& bytes, const T* values, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

// A frame as bytes: its time, the number of its particles, its arrays.
std::string packed(const Frame& frame) {
  const std::uint64_t count = frame.x.size();
  std::string bytes;
  append(bytes, &frame.time_s, 1);
  append(bytes, &count, 1);
  for_each_array(frame, [&](const auto& array) { append(bytes, array.data(), array.size()); });
  return bytes;
}

// Reads no further than the bytes that are there, whatever the numbers in them say.
template <class T>
bool take(std::string_view& bytes, T* values, std::uint64_t count) {
  if (count > bytes.size() / sizeof(T)) return false;
  std::memcpy(values, bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
  return true;
}

bool unpack(std::string_view bytes, Frame& frame) {
  std::uint64_t count = 0;
  bool whole = take(bytes, &frame.time_s, 1) && take(bytes, &count, 1) && count <= bytes.size();
  for_each_array(frame, [&](auto& array) {
    if (!whole) return;
    array.resize(count);
    whole = take(bytes, array.data(), count);
  });
  return whole && bytes.empty();
}

std::string next_in_chain(const std::string& chain, const std::string& frame) {
  return disk::sha256_of(chain + disk::sha256_of(frame));
}

// The frames in the first bytes of a file, one after the other.
class FrameReader {
 public:
  FrameReader(const fs::path& file, std::uintmax_t bytes)
      : in_(file, std::ios::binary), left_(bytes) {
    std::error_code error;
    if (fs::file_size(file, error) < bytes || error) left_ = 0;
  }

  // Empty at the end, and where what follows is no frame.
  std::string next() {
    std::uint64_t size = 0;
    if (left_ < sizeof size) return "";
    in_.read(reinterpret_cast<char*>(&size), sizeof size);
    left_ -= sizeof size;
    if (!in_ || size > left_) return "";
    std::string bytes(size, '\0');
    in_.read(bytes.data(), static_cast<std::streamsize>(size));
    left_ -= size;
    return in_ ? bytes : "";
  }

 private:
  std::ifstream in_;
  std::uintmax_t left_;
};

// The rest of the line that begins with a word.
std::string value_of(const std::string& word, std::istream& lines) {
  std::string line;
  if (!std::getline(lines, line) || !line.starts_with(word + " ")) return "";
  return line.substr(word.size() + 1);
}

}  // namespace

RunCheckpoint::RunCheckpoint(const fs::path& folder, std::string sha256, std::string version)
    : state_file_(folder / state_name),
      frames_file_(folder / frames_name),
      sha256_(std::move(sha256)),
      version_(std::move(version)) {}

std::string RunCheckpoint::head(std::string_view state, const Frames& frames) const {
  return fmt::format("{}\ncase {}\nversion {}\nframes {} {} {}\nstate {}\n", first_line, sha256_,
                     version_, frames.count, frames.bytes, frames.chain, disk::sha256_of(state));
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
    return fmt::format("leda {} wrote it, this is leda {}", version.substr(0, 80), version_);
  }
  head_bytes = static_cast<std::size_t>(lines.tellg());
  const auto state = std::string_view(bytes).substr(head_bytes);
  if (state.empty() || !bytes.starts_with(head(state, frames))) return "it is damaged or cut off";
  return "";
}

// Whether frames.bin begins with exactly these frames.
bool RunCheckpoint::stand(const Frames& wanted) const {
  Frames found;
  Frame frame;
  FrameReader reader(frames_file_, wanted.bytes);
  for (std::string bytes = reader.next(); !bytes.empty(); bytes = reader.next()) {
    if (!unpack(bytes, frame)) return false;
    ++found.count;
    found.bytes += sizeof(std::uint64_t) + bytes.size();
    found.chain = next_in_chain(found.chain, bytes);
  }
  return found.count == wanted.count && found.bytes == wanted.bytes && found.chain == wanted.chain;
}

RunCheckpoint::Left RunCheckpoint::read() {
  Left left;
  if (!fs::exists(state_file_)) return left;
  std::string bytes = read_all(state_file_);
  Frames frames;
  std::size_t head_bytes = 0;
  left.refused = mismatch(bytes, frames, head_bytes);
  if (left.refused.empty() && !stand(frames)) left.refused = "its frames are damaged or cut off";
  if (!left.refused.empty()) return left;
  left.state = std::move(bytes.erase(0, head_bytes));
  left.frames = frames.count;
  frames_ = frames;
  return left;
}

void RunCheckpoint::go_on(const std::function<void(const Frame&)>& show) {
  if (frames_.count == 0) return;
  fs::resize_file(frames_file_, frames_.bytes);
  FrameReader reader(frames_file_, frames_.bytes);
  Frame frame;
  for (std::int64_t i = 0; i < frames_.count; ++i) {
    if (!unpack(reader.next(), frame)) {
      throw disk::FileError(frames_file_.string() + " has changed since it was checked");
    }
    show(frame);
  }
}

void RunCheckpoint::begin() {
  frames_ = {};
  remove_checkpoint(state_file_.parent_path());
}

void RunCheckpoint::add(const Frame& frame) {
  const std::string bytes = packed(frame);
  const std::uint64_t size = bytes.size();
  disk::append_to_file(frames_file_, {reinterpret_cast<const char*>(&size), sizeof size}, bytes);
  ++frames_.count;
  frames_.bytes += sizeof size + bytes.size();
  frames_.chain = next_in_chain(frames_.chain, bytes);
}

void RunCheckpoint::keep(const std::string& state, std::int64_t frames) {
  if (frames != frames_.count) {
    throw std::logic_error(fmt::format("{} frames were shown and {} kept", frames, frames_.count));
  }
  if (frames_.count > 0) disk::sync_to_disk(frames_file_);
  disk::write_durably(state_file_, head(state, frames_), state);
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
