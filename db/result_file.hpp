#pragma once
// fields.h5: the particles of a run over time. Layout: db/README.md.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "solver/section/frame.hpp"

namespace leda::db {

/// Writes frames under a temporary name beside `file` and renames on close(); a file that is
/// not closed is removed. Throws std::runtime_error naming the file when HDF5 fails.
class ResultFileWriter {
 public:
  ResultFileWriter(const std::filesystem::path& file, const std::vector<std::string>& materials,
                   const std::string& case_sha256, const std::string& version);
  ~ResultFileWriter();
  ResultFileWriter(const ResultFileWriter&) = delete;
  ResultFileWriter& operator=(const ResultFileWriter&) = delete;

  /// Throws std::invalid_argument where the frame's arrays differ in length.
  void append(const Frame& frame);
  void close();  ///< the file stands under its name and is on the disk

 private:
  struct File;
  std::unique_ptr<File> file_;
};

struct ResultFileOrigin {
  std::vector<std::string> materials;  ///< in the order Frame::material counts them
  std::string case_sha256;
  std::string version;
};

/// Throws std::runtime_error naming the file and what is wrong with it.
ResultFileOrigin read_result_file_origin(const std::filesystem::path& file);

/// Every frame of a file, in time order. Throws std::runtime_error naming the file and what is
/// wrong with it: missing, truncated, damaged (its bytes carry checksums), or of another kind.
std::vector<Frame> read_result_file(const std::filesystem::path& file);

/// Which frames of a file, and what of them.
struct FrameWindow {
  std::size_t first = 0, count = 0;
  std::size_t most_particles = 0;   ///< of all frames together; fewer frames are read then
  std::vector<std::string> fields;  ///< names of frame_fields; the others stay empty
  bool material = false;
};

struct FramePart {
  std::vector<Frame> frames;    ///< fewer than asked for where the file ends, or at most_particles
  std::vector<double> times_s;  ///< of every frame of the file
  std::vector<std::string> materials;  ///< in the order Frame::material counts them
};

/// A part of a file, without reading the rest. At least one frame where there is one at `first`.
/// Throws as read_result_file.
FramePart read_frames(const std::filesystem::path& file, const FrameWindow& window);

}  // namespace leda::db
