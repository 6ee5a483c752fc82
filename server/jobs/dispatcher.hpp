#pragma once
// What runs next, and what becomes of a run that ended. The truth is in the store: after kill -9
// at any moment a new dispatcher takes up everything unfinished, and counts nothing twice.

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "db/store.hpp"
#include "server/jobs/executors/executor.hpp"
#include "server/jobs/process.hpp"
#include "server/jobs/section_queue.hpp"
#include "server/jobs/take_in.hpp"
#include "server/operate/data_folder.hpp"

namespace leda::server {

/// What happens to runs, for whoever counts. Called from the dispatcher's thread.
struct RunWatch {
  std::function<void(const SectionResult&)> taken_in;
  std::function<void(int)> restarted;  ///< how many runs
};

class Dispatcher {
 public:
  /// A run that crashes is tried this often in the life of one dispatcher.
  static constexpr int most_tries = 3;

  using MakeExecutor = std::function<std::unique_ptr<Executor>()>;

  /// The executor is made, used and destroyed in the dispatcher's own thread.
  Dispatcher(const DataFolder& data, db::Store& store, MakeExecutor make_executor,
             RunWatch watch = {});
  /// Ends the runs that still go, where they can't outlive the server: a later dispatcher lets
  /// them go on from their checkpoints, and adopts the others.
  ~Dispatcher();
  Dispatcher(const Dispatcher&) = delete;
  Dispatcher& operator=(const Dispatcher&) = delete;

  /// Takes up every unfinished job of the store, then works until it is destroyed.
  void start();
  /// A job was committed to the store, or put back by retry.
  void add(const std::string& job);
  /// Ends a job: at once in the store, and its runs as soon as the dispatcher's thread gets to it.
  void dismiss(const std::string& job);
  /// Runs going on now.
  std::size_t running() const;
  /// How long ago it last looked at its jobs without a failure.
  std::chrono::steady_clock::duration since_last_turn() const;

 private:
  struct OpenJob {
    db::JobRecord record;  ///< without its request, which may be long
    std::shared_ptr<Work> work;
    SectionQueue sections;               ///< in step with the store
    std::map<std::size_t, int> crashes;  ///< by index of the section
    std::size_t running = 0;
  };
  struct Run {
    std::string job;
    std::size_t section = 0;  ///< index in the job's sections
  };

  using Fractions = std::map<std::string, double>;  ///< by job: running sections, as far as done

  void work();
  void turn();
  void take_up_new_jobs();
  bool screened_out(OpenJob& job, std::size_t index, db::SectionRecord& section);
  void take_up(const std::string& id);
  std::optional<OpenJob> open(const std::string& id);
  void let_go_dismissed_jobs();
  void let_go(const std::string& job);
  void recover(OpenJob& job);
  void settle_ended_runs();
  void settle(const RunEnd& end);
  void take_in(OpenJob& job, std::size_t index, const std::string& run, const Outcome& outcome);
  void gave_no_result(OpenJob& job, std::size_t index, const RunEnd& end, const Outcome& outcome);
  void start_runs();
  bool start_next();
  void start_run(OpenJob& job, std::size_t index, db::SectionRecord& section);
  std::optional<std::string> new_run(const OpenJob& job, const db::SectionRecord& section);
  void wait_for_space();
  void remove_checkpoint_of(const std::string& run);
  void book_started_jobs();
  std::optional<Fractions> read_fractions();
  void report_progress();
  void finish_done_jobs();
  void finish(const OpenJob& job);
  void wind_down();
  void set_state(OpenJob& job, std::size_t index, db::SectionState state,
                 const std::string& reason);

  const DataFolder& data_;
  db::Store& store_;
  MakeExecutor make_executor_;
  RunWatch watch_;
  std::atomic<std::chrono::steady_clock::time_point> last_turn_;

  std::atomic<std::size_t> running_{0};

  std::mutex inbox_mutex_;  ///< guards these four; never held for long
  std::condition_variable wake_;
  std::deque<std::string> to_take_up_;
  std::vector<std::string> to_let_go_;  ///< dismissed jobs
  bool stop_ = false;

  // All below is of the dispatcher's thread alone, so that no handler waits for what it does.
  std::deque<RunEnd> ended_;  ///< not settled yet
  std::unique_ptr<Executor> executor_;
  std::map<std::string, OpenJob> jobs_;
  std::map<std::string, Run> runs_;
  std::chrono::steady_clock::time_point progress_told_{};
  /// While the disk is full no run is started before this, and the pause doubles.
  std::chrono::steady_clock::time_point no_start_before_{};
  std::chrono::milliseconds pause_for_space_{0};
  std::thread thread_;
};

}  // namespace leda::server
