#pragma once
// What a run that was cut off leaves in its folder so that it can go on: checkpoint.bin (the
// solver's state) and frames.bin (the frames shown before it).

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "solver/section/frame.hpp"

namespace leda::server {

class RunCheckpoint {
 public:
  /// @param sha256 of the case
  /// @param version of the program, and how it computes where that may be chosen
  RunCheckpoint(const std::filesystem::path& folder, std::string sha256, std::string version);

  /// What stands in the folder.
  struct Left {
    std::string state;        ///< empty: none that can be trusted
    std::int64_t frames = 0;  ///< shown before it
    std::string refused;      ///< why there is a checkpoint and no state; empty otherwise
  };
  /// Changes nothing. A checkpoint of another case or version is refused, and a damaged one.
  Left read();

  /// Then one of these two, before add() and keep(). go_on(): from what read() gave; shows the
  /// frames before the checkpoint, one in memory at a time, and drops those after it. begin():
  /// anew, what stands is removed.
  void go_on(const std::function<void(const Frame&)>& show);
  void begin();

  void add(const Frame& frame);  ///< to frames.bin
  /// Replaces checkpoint.bin, and brings it and the frames before it to the disk.
  void keep(const std::string& state, std::int64_t frames);

 private:
  struct Frames {
    std::int64_t count = 0;
    std::uintmax_t bytes = 0;
    std::string chain;  ///< sha256 of the chain before and the sha256 of the last frame
  };
  std::string head(std::string_view state, const Frames& frames) const;
  bool stand(const Frames& wanted) const;
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
