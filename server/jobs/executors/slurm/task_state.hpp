#pragma once
// What Slurm says of the tasks of arrays, read from the texts of its programs.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "server/jobs/executors/executor.hpp"

namespace leda::server {

/// A task by the name of its array and its index in it. Names of arrays are never used twice,
/// which Slurm's own numbers are after its state was lost.
using TaskKey = std::pair<std::string, std::size_t>;

struct TaskState {
  std::string array_id;  ///< Slurm's number of the array
  std::string state;     ///< "RUNNING", "COMPLETED", ...
  int exit_code = 0;
  int signal = 0;

  bool is_over() const;
};

/// Answer of `squeue -r -h -o %F|%K|%T|%j`: what waits, runs or ends just now.
std::map<TaskKey, TaskState> read_queue(std::string_view text);

/// Answer of `scontrol -o show job`, or lines of the file that jobcomp/filetxt writes. Of several
/// lines about one task the last counts. Tasks that have not been split off their array yet
/// ("3-9%2") are left out.
std::map<TaskKey, TaskState> read_records(std::string_view text);

/// The end of a run by the last state of its task.
/// @param asked whether Leda cancelled it
/// @param begun whether the worker told of any progress
RunEnd end_of(const std::string& run, const TaskState& task, bool asked, bool begun);

/// Indices as sbatch --array takes them: "0-2,5". @param indices ascending
std::string array_range(const std::vector<std::size_t>& indices);

}  // namespace leda::server
