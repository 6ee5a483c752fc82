#include "server/commands/run_options.hpp"

#include <algorithm>
#include <cmath>
#include <thread>

namespace leda::server {

void add_worker_options(CLI::App& command, WorkerOptions& options) {
  command.add_option("--workers", options.workers, "runs at the same time; 0: one a core")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command.add_option("--executor", options.executor, "where runs are computed")
      ->check(CLI::IsMember({"local"}))
      ->capture_default_str();
  command.add_option("--run-memory-gb", options.memory_GB, "most memory of one run, GB")
      ->check(CLI::Range(0.1, 10'000.0))
      ->capture_default_str();
  command.add_option("--run-time-limit-s", options.time_limit_s, "longest time of one run, s")
      ->check(CLI::Range(1.0, 1e8))
      ->capture_default_str();
}

ServiceOptions service_options(const WorkerOptions& options) {
  ServiceOptions service;
  service.workers =
      options.workers > 0 ? options.workers : std::max(1U, std::thread::hardware_concurrency());
  service.run_limits.memory_bytes = static_cast<std::uint64_t>(options.memory_GB * 1e9);
  service.run_limits.cpu_s = static_cast<std::uint64_t>(std::ceil(options.time_limit_s));
  service.run_limits.wall =
      std::chrono::seconds(static_cast<std::int64_t>(std::ceil(options.time_limit_s)));
  return service;
}

}  // namespace leda::server
