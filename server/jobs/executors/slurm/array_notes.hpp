#pragma once
// The notes of arrays: what each task of an array computes, written before Slurm hears of it and
// kept until its last task is over. The nodes read them, and so does a server that starts again.

#include <filesystem>
#include <string>
#include <vector>

#include "server/jobs/executors/local_executor.hpp"

namespace leda::server {

struct ArrayNote {
  std::string name;                            ///< of the array in Slurm, never used twice
  std::string id;                              ///< Slurm's number; empty: not known
  std::filesystem::path program;               ///< leda, or what stands for it
  RunLimits limits;                            ///< the wall limit is Slurm's
  std::vector<std::filesystem::path> folders;  ///< of the runs, by index of the task
};

/// @throws std::runtime_error naming a note that can't be read
ArrayNote read_note(const std::filesystem::path& file);

class ArrayNotes {
 public:
  /// @throws std::runtime_error where the folder can't be made
  explicit ArrayNotes(const std::filesystem::path& folder);

  /// Every array that is not over, by name.
  std::vector<ArrayNote> read() const;
  /// A name for a new array, beginning with prefix().
  std::string new_name() const;
  /// What the names of all arrays of this folder, and of no other, begin with.
  const std::string& prefix() const { return prefix_; }

  std::filesystem::path file(const std::string& name) const { return folder_ / (name + ".json"); }
  /// Where tasks write until they know their run's log.
  std::filesystem::path output(const std::string& name) const { return folder_ / (name + ".out"); }
  std::filesystem::path batch_script() const { return folder_ / "task"; }

  /// Appears whole or not at all; replaces an older one. @throws std::runtime_error
  void write(const ArrayNote& note) const;
  void remove(const std::string& name) const;

 private:
  std::filesystem::path folder_;
  std::string prefix_;
};

}  // namespace leda::server
