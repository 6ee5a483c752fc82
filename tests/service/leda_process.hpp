#pragma once
// `leda serve` as a process of its own, and a client that talks to it.

#include <httplib.h>
#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace leda::tests {

class LedaServer {
 public:
  /// Starts it on a free port and waits until it answers. @throws std::runtime_error
  explicit LedaServer(const std::filesystem::path& data, const std::vector<std::string>& more = {});
  /// Kills what still runs.
  ~LedaServer();
  LedaServer(const LedaServer&) = delete;
  LedaServer& operator=(const LedaServer&) = delete;

  httplib::Client& client() { return *client_; }
  const std::string& url() const { return url_; }
  pid_t process() const { return process_; }

  void kill_hard();
  /// SIGTERM. @return seconds until it was gone
  double end();
  /// Process ids of its workers.
  std::vector<pid_t> workers() const;

  /// The JSON of an answer that must be 200.
  nlohmann::json get(const std::string& path);
  /// Polls a job. @return its status when it is finished, or after `patience`
  nlohmann::json wait_for_job(const std::string& job,
                              std::chrono::seconds patience = std::chrono::seconds(240));

 private:
  pid_t process_ = 0;
  std::string url_;
  std::unique_ptr<httplib::Client> client_;
};

struct Output {
  int exit_code = -1;
  std::string text;    ///< standard output
  std::string errors;  ///< standard error
};

/// Runs `leda` with these arguments to its end.
Output run_leda(const std::vector<std::string>& arguments);

/// Runs a program of this machine to its end; nothing where it is not installed.
std::optional<Output> run_program(const std::vector<std::string>& arguments);

/// As /proc has it: 'R', 'S', 'T' (stopped), 'Z' (dead, not yet buried by its parent), ...; 0 where
/// there is no such process.
char state_of(pid_t process);

bool is_alive(pid_t process);

/// The folder of the run that a worker computes, from what it was called with; empty where it is
/// gone.
std::filesystem::path run_folder_of(pid_t worker);

}  // namespace leda::tests
