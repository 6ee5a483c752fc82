#pragma once
// What a run that was cut off leaves in its folder so that it can go on: checkpoint.bin (the
// solver's state) and frames.bin (the frames shown before it).

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "solver/section/frame.hpp"

namespace leda::server {

class RunCheckpoint {
 public:
  /// @param sha256 of the case
  /// @param version of the program
  RunCheckpoint(std::filesystem::path folder, std::string sha256, std::string version);

  /// What stands in the folder.
  struct Left {
    std::string state;  ///< empty: none that can be trusted
    std::vector<Frame> frames;
    std::string refused;  ///< why there is a checkpoint and no state; empty otherwise
  };
  /// Changes nothing. A checkpoint of another case or version is refused, and a damaged one.
  Left read();

  /// Then one of these two, before add() and keep().
  void go_on();  ///< from what read() gave: frames after the checkpoint are dropped
  void begin();  ///< anew: what stands is removed

  void add(const Frame& frame);  ///< to frames.bin
  /// Replaces checkpoint.bin, and brings it and the frames before it to the disk.
  void keep(const std::string& state, std::int64_t frames);

 private:
  struct Frames {
    std::int64_t count = 0;
    std::uintmax_t bytes = 0;
    std::string chain;  ///< sha256 over the chain before and the last frame
  };
  std::string head(const std::string& state, const Frames& frames) const;
  std::string mismatch(const std::string& bytes, Frames& frames, std::size_t& head_bytes) const;

  std::filesystem::path state_file_, frames_file_;
  std::string sha256_, version_;
  Frames frames_;
};

/// Removes the checkpoint of a run folder, if there is one.
void remove_checkpoint(const std::filesystem::path& folder);

/// Lets a new try go on where another was cut off: its checkpoint, if there is one, stands in both
/// folders then. Throws std::filesystem::filesystem_error.
/// @return whether there was one
bool hand_over_checkpoint(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace leda::server
