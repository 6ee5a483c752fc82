#include "server/commands/run_options.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "server/jobs/executors/spawn.hpp"

namespace leda::server {
namespace {

void add_slurm_options(CLI::App& command, WorkerOptions& options) {
  SlurmSettings& slurm = options.slurm;
  slurm.program = program_beside();
  const auto add = [&](const char* name, auto& value, const char* what) {
    return command.add_option(name, value, what)->group("Slurm");
  };
  add("--slurm-partition", slurm.partition, "empty: the site's default");
  add("--slurm-account", slurm.account, "empty: the user's default");
  add("--slurm-option", slurm.options, "further option of sbatch, as --constraint=NAME; repeated")
      ->allow_extra_args(false);
  add("--slurm-shared-folder", slurm.shared_folder,
      "for run folders, same path on each node; empty: the data folder is");
  add("--slurm-program", slurm.program, "leda as the nodes reach it")->capture_default_str();
  add("--slurm-max-array-size", slurm.max_array_size, "MaxArraySize of the site's slurm.conf")
      ->check(CLI::Range(1, 4'000'001))
      ->capture_default_str();
  add("--slurm-most-queued", slurm.most_queued, "runs in Slurm at the same time")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  add("--slurm-most-running", slurm.most_running, "runs of one array at the same time; 0: all")
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  add("--slurm-completion-file", slurm.completion_file,
      "JobCompLoc of jobcomp/filetxt, where it can be read here");
  add("--slurm-look-every-s", options.slurm_look_every_s, "between looks at the queue, s")
      ->check(CLI::Range(0.1, 3600.0))
      ->capture_default_str();
  add("--slurm-settle-s", options.slurm_settle_s,
      "how late files of a run may show in the shared folder, s")
      ->check(CLI::Range(0.0, 3600.0))
      ->capture_default_str();
}

std::chrono::milliseconds milliseconds(double seconds) {
  return std::chrono::milliseconds(static_cast<std::int64_t>(std::llround(seconds * 1000)));
}

void refuse_faults(const SlurmSettings& settings) {
  std::string text;
  for (const auto& fault : faults_of(settings)) text += "\n  " + fault;
  const std::atomic<bool> never{false};
  const Said said = ask_program({"sbatch", "--version"}, std::chrono::seconds(20), never);
  if (!said.ended || said.exit_code != 0) text += "\n  Slurm's programs: " + said.errors;
  if (!text.empty()) throw std::runtime_error("runs can't go out to Slurm:" + text);
}

}  // namespace

void add_worker_options(CLI::App& command, WorkerOptions& options) {
  command.add_option("--workers", options.workers, "runs at the same time; 0: one a core")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command.add_option("--executor", options.executor, "where runs are computed: local or slurm")
      ->check(CLI::IsMember({"local", "slurm"}))
      ->capture_default_str();
  command.add_option("--run-memory-gb", options.memory_GB, "most memory of one run, GB")
      ->check(CLI::Range(0.1, 10'000.0))
      ->capture_default_str();
  command.add_option("--run-time-limit-s", options.time_limit_s, "longest time of one run, s")
      ->check(CLI::Range(1.0, 1e8))
      ->capture_default_str();
  add_slurm_options(command, options);
}

ServiceOptions service_options(const WorkerOptions& options) {
  ServiceOptions service;
  service.workers =
      options.workers > 0 ? options.workers : std::max(1U, std::thread::hardware_concurrency());
  service.run_limits.memory_bytes = static_cast<std::uint64_t>(options.memory_GB * 1e9);
  service.run_limits.cpu_s = static_cast<std::uint64_t>(std::ceil(options.time_limit_s));
  service.run_limits.wall =
      std::chrono::seconds(static_cast<std::int64_t>(std::ceil(options.time_limit_s)));
  if (options.executor == "slurm") {
    service.runs_on = RunsOn::slurm;
    service.slurm = options.slurm;
    service.slurm.look_every = milliseconds(options.slurm_look_every_s);
    service.slurm.settle = milliseconds(options.slurm_settle_s);
    refuse_faults(service.slurm);
  }
  return service;
}

}  // namespace leda::server
