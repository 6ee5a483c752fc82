#pragma once
// What an interrupted run leaves in its folder so that the same command continues:
// checkpoint.bin (the solver's state) and frames.bin (the frames shown before it).

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "solver/section/frame.hpp"

namespace leda::server {

class RunCheckpoint {
 public:
  /// @param sha256 of the case; a checkpoint of another case or program is ignored
  RunCheckpoint(std::filesystem::path folder, std::string sha256, std::string version);

  /// Reads what stands: empty state where there is none, or none that can be trusted. Frames
  /// after the checkpoint are dropped from frames.bin.
  struct Left {
    std::string state;
    std::vector<Frame> frames;
  };
  Left read();

  void add(const Frame& frame);  ///< to frames.bin
  /// Replaces checkpoint.bin (temporary name, then renamed).
  void keep(const std::string& state, std::int64_t frames);
  void remove();

 private:
  std::string head(const std::string& state, std::int64_t frames) const;
  std::filesystem::path state_file_, frames_file_;
  std::string sha256_, version_;
};

}  // namespace leda::server
