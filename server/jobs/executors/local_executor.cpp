#include "server/jobs/executors/local_executor.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <utility>
#include <vector>

namespace leda::server {
namespace {

constexpr std::chrono::milliseconds patience{3000};  // between SIGTERM and SIGKILL

constexpr int lower_priority = 5;  // answers come before runs

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool can_limit_memory = false;  // its shadow memory takes terabytes of address space
#else
constexpr bool can_limit_memory = true;
#endif

// Everything from here to run_child is called between fork and exec: system calls only.

void limit(decltype(RLIMIT_AS) what, rlim_t soft, rlim_t hard) {
  const rlimit value{soft, hard};
  setrlimit(what, &value);
}

[[noreturn]] void run_child(char* const* arguments, int log, pid_t server,
                            const RunLimits& limits) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != server) _exit(127);  // the server died before the line above
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  static_cast<void>(signal(SIGPIPE, SIG_DFL));
  const int null = open("/dev/null", O_RDONLY);
  dup2(null, STDIN_FILENO);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  close_range(3, ~0U, 0);  // sockets and the store are not the worker's
  setpriority(PRIO_PROCESS, 0, lower_priority);
  limit(RLIMIT_CORE, 0, 0);
  if (can_limit_memory && limits.memory_bytes > 0) {
    limit(RLIMIT_AS, limits.memory_bytes, limits.memory_bytes);
  }
  if (limits.cpu_s > 0) limit(RLIMIT_CPU, limits.cpu_s, limits.cpu_s + 5);
  execv(arguments[0], arguments);
  const char message[] = "the program of the run could not be started\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, message, sizeof(message) - 1);
  _exit(127);
}

/// How many processes this machine has killed for want of memory; 0 where it does not tell.
std::int64_t oom_kills() {
  std::ifstream in("/proc/vmstat");
  std::string name;
  for (std::int64_t value = 0; in >> name >> value;) {
    if (name == "oom_kill") return value;
  }
  return 0;
}

}  // namespace

LocalExecutor::LocalExecutor(std::filesystem::path program, std::size_t workers, RunLimits limits)
    : program_(std::move(program)), workers_(workers), limits_(limits) {}

LocalExecutor::~LocalExecutor() {
  for (const auto& [run, worker] : running_) kill(worker.process, SIGKILL);
  for (const auto& [run, worker] : running_) waitpid(worker.process, nullptr, 0);
}

std::size_t LocalExecutor::free_slots() const {
  return workers_ > running_.size() ? workers_ - running_.size() : 0;
}

void LocalExecutor::submit(const RunOrder& order) {
  std::string program = program_.string();
  auto words = worker_arguments(order);
  std::vector<char*> arguments{program.data()};
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const int log =
      open((order.folder / "log.txt").c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  const std::int64_t oom_kills_before = oom_kills();
  const pid_t server = getpid();
  const pid_t child = log < 0 ? -1 : fork();
  if (child == 0) run_child(arguments.data(), log, server, limits_);
  const int error = errno;
  if (log >= 0) close(log);
  if (child < 0) {
    not_started_.push_back({order.run, RunEnd::How::killed, 0,
                            std::string("the worker could not be started: ") + strerror(error)});
    return;
  }
  Worker worker;
  worker.process = child;
  worker.folder = order.folder;
  worker.started = Clock::now();
  worker.oom_kills = oom_kills_before;
  running_[order.run] = worker;
}

void LocalExecutor::enforce(Worker& worker) const {
  const auto now = Clock::now();
  const bool asked = worker.asked_to_end != Clock::time_point{};
  if (!asked && limits_.wall.count() > 0 && now - worker.started > limits_.wall) {
    worker.over_wall = true;
    worker.asked_to_end = now;
    kill(worker.process, SIGTERM);
  }
  if (asked && now - worker.asked_to_end > patience) kill(worker.process, SIGKILL);
}

RunEnd LocalExecutor::end_of(const std::string& run, int status, const Worker& worker) {
  RunEnd end{run, RunEnd::How::exited, 0, ""};
  if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
  const int signal_number = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (worker.cancelled) {
    end.how = RunEnd::How::cancelled;
    end.reason = "cancelled";
  } else if (worker.over_wall) {
    end = out_of_time(run, has_begun(worker.folder));
  } else if (signal_number == SIGXCPU) {
    end.how = RunEnd::How::over_limit;
    end.reason = "the run used more processor time than it may";
  } else if (signal_number == SIGKILL && oom_kills() > worker.oom_kills) {
    end.how = RunEnd::How::killed;
    end.reason = "memory: the machine had none left and ended the worker";
  } else if (signal_number != 0) {
    end.how = RunEnd::How::killed;
    end.reason = std::string("the worker died of signal ") + std::to_string(signal_number) + " (" +
                 strsignal(signal_number) + ")";
  } else if (end.exit_code != 0) {
    end.reason = "the worker ended with code " + std::to_string(end.exit_code);
  }
  return end;
}

std::vector<RunEnd> LocalExecutor::poll() {
  std::vector<RunEnd> ended = std::exchange(not_started_, {});
  for (auto at = running_.begin(); at != running_.end();) {
    auto& [run, worker] = *at;
    int status = 0;
    if (waitpid(worker.process, &status, WNOHANG) == worker.process) {
      ended.push_back(end_of(run, status, worker));
      at = running_.erase(at);
    } else {
      enforce(worker);
      ++at;
    }
  }
  return ended;
}

void LocalExecutor::cancel(const std::string& run) {
  const auto found = running_.find(run);
  if (found == running_.end() || found->second.cancelled) return;
  found->second.cancelled = true;
  found->second.asked_to_end = Clock::now();
  kill(found->second.process, SIGTERM);
}

std::filesystem::path program_beside() {
  return std::filesystem::read_symlink("/proc/self/exe").replace_filename("leda");
}

}  // namespace leda::server
