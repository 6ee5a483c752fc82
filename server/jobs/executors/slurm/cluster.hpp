#pragma once
// What Leda says to Slurm: sbatch, squeue, scontrol, scancel, each started with a list of
// arguments.

#include <atomic>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "server/jobs/executors/slurm/array_notes.hpp"
#include "server/jobs/executors/slurm/settings.hpp"
#include "server/jobs/executors/slurm/task_state.hpp"
#include "server/jobs/executors/spawn.hpp"

namespace leda::server {

class Cluster {
 public:
  /// @param stop ends a command that waits for the controller
  Cluster(SlurmSettings settings, RunLimits limits, const std::atomic<bool>& stop);

  struct Answer {
    enum class Kind {
      accepted,
      later,   ///< no answer, or not now: what Slurm knows of the array has to be asked
      refused  ///< it will never be accepted as it is
    };
    Kind kind = Kind::later;
    std::string text;  ///< the number of the array, or why there is none
  };
  /// @param indices of the tasks to start, ascending
  Answer submit(const ArrayNotes& notes, const ArrayNote& note,
                const std::vector<std::size_t>& indices) const;

  using States = std::map<TaskKey, TaskState>;
  /// Tasks of arrays whose name begins so. Nothing where the controller can't be asked; why() then
  /// says what it said.
  std::optional<States> queue(const std::string& prefix) const;
  /// What the controller and the file of completed jobs still know of an array. Nothing where the
  /// controller can't be asked.
  std::optional<States> records(const std::string& name, const std::string& id) const;
  /// Ends tasks, named "ID_INDEX". Asked again until they are gone from the queue.
  void cancel(const std::vector<std::string>& tasks) const;

  const std::string& why() const { return why_; }

 private:
  Said ask(const std::vector<std::string>& arguments) const;

  SlurmSettings settings_;
  RunLimits limits_;
  const std::atomic<bool>& stop_;
  mutable std::string why_;
};

}  // namespace leda::server
