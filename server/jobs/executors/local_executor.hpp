#pragma once
// Runs as processes of this machine: `leda simulate FOLDER/case.json --out FOLDER`.

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>

#include "server/jobs/executors/executor.hpp"

namespace leda::server {

/// What one run may use. 0: no limit.
struct RunLimits {
  std::uint64_t memory_bytes = std::uint64_t{8} << 30;  ///< address space
  std::uint64_t cpu_s = std::uint64_t{6} * 3600;
  std::chrono::seconds wall{8 * 3600};
};

/// Processes die with the thread that submits them (PR_SET_PDEATHSIG), so a killed server leaves
/// none behind: submit() must be called from one thread that lives as long as the executor.
/// Output goes to FOLDER/log.txt. Not safe for several threads.
class LocalExecutor final : public Executor {
 public:
  /// @param program the leda executable
  LocalExecutor(std::filesystem::path program, std::size_t workers, RunLimits limits = {});
  /// Kills what still runs.
  ~LocalExecutor() override;
  LocalExecutor(const LocalExecutor&) = delete;
  LocalExecutor& operator=(const LocalExecutor&) = delete;

  std::size_t free_slots() const override;
  void submit(const RunOrder& order) override;
  std::vector<RunEnd> poll() override;
  void cancel(const std::string& run) override;

 private:
  using Clock = std::chrono::steady_clock;
  struct Worker {
    pid_t process = 0;
    std::filesystem::path folder;
    Clock::time_point started;
    bool cancelled = false;
    bool over_wall = false;
    Clock::time_point asked_to_end{};  ///< SIGKILL follows three seconds later
    std::int64_t oom_kills = 0;        ///< of the machine, when it was started
  };

  void enforce(Worker& worker) const;
  static RunEnd end_of(const std::string& run, int status, const Worker& worker);

  std::filesystem::path program_;
  std::size_t workers_;
  RunLimits limits_;
  std::map<std::string, Worker> running_;
  std::vector<RunEnd> not_started_;
};

/// The program `leda` in the folder of the running one.
std::filesystem::path program_beside();

}  // namespace leda::server
