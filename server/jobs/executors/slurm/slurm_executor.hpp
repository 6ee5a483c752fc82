#pragma once
// Runs as tasks of Slurm job arrays.

#include <atomic>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <unordered_map>
#include <vector>

#include "server/jobs/executors/executor.hpp"
#include "server/jobs/executors/slurm/array_notes.hpp"
#include "server/jobs/executors/slurm/cluster.hpp"
#include "server/jobs/executors/slurm/settings.hpp"

namespace leda::server {

/// Runs that are submitted within a moment become one array of at most max_array_size tasks, which
/// Slurm keeps when the server ends: the next one adopts them by the notes in `notes`. All talk
/// with Slurm is in a thread of its own, because a controller that is down answers after seconds;
/// a controller that does not answer says nothing about any run.
class SlurmExecutor final : public Executor {
 public:
  /// @param program of the runs: leda, as the nodes know it
  /// @param notes a folder that the nodes can read; made where it is missing
  /// @throws std::runtime_error where the settings can't work
  SlurmExecutor(std::filesystem::path program, SlurmSettings settings, RunLimits limits,
                const std::filesystem::path& notes);
  /// Leaves the runs to Slurm.
  ~SlurmExecutor() override;
  SlurmExecutor(const SlurmExecutor&) = delete;
  SlurmExecutor& operator=(const SlurmExecutor&) = delete;

  std::size_t free_slots() const override;
  void submit(const RunOrder& order) override;
  std::vector<RunEnd> poll() override;
  void cancel(const std::string& run) override;
  bool outlives_server() const override { return true; }
  bool adopt(const RunOrder& order) override;

 private:
  using Clock = std::chrono::steady_clock;
  struct Task {
    std::string run;
    std::filesystem::path folder;
    bool over = false;
    bool cancelled = false;
    bool adopted = true;                      ///< false: of an earlier server, and nobody asked
    std::optional<Clock::time_point> gone{};  ///< since when Slurm has it no more, or it is over
  };
  struct Array {
    ArrayNote note;
    std::vector<Task> tasks;
    bool asked = false;  ///< sbatch was called, maybe by an earlier server
  };

  // In the thread that talks with Slurm, without the lock:
  void follow();
  void look();
  void make_arrays();
  bool start(const std::string& name, const Cluster::States& queue);
  void settle(const std::string& name, const Cluster::States& queue);
  void cancel_in(const Cluster::States& queue);

  // With the lock:
  bool is_gathered() const;
  void give_up_orphans();
  void tell(Task& task, RunEnd end);
  void end_task(Task& task, const Cluster::States& records, const std::string& name,
                std::size_t index);
  void forget_finished();
  void add(Array array);
  Task* task_of(const std::string& run);

  SlurmSettings settings_;
  RunLimits limits_;
  std::filesystem::path program_;
  ArrayNotes notes_;
  std::atomic<bool> stop_{false};
  Cluster cluster_;
  bool answered_ = true;  ///< of the following thread

  mutable std::mutex mutex_;  ///< guards everything below
  std::condition_variable wake_;
  std::vector<RunOrder> orders_;  ///< of no array yet
  Clock::time_point last_order_{};
  std::map<std::string, Array> arrays_;
  std::unordered_map<std::string, Task*> tasks_;  ///< of arrays_, by their run
  std::vector<RunEnd> ended_;
  std::size_t held_ = 0;  ///< runs submitted or adopted whose end was not told
  std::thread thread_;
};

}  // namespace leda::server
