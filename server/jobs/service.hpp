#pragma once
// Everything a request or a command can reach: the data folder, its store, its dispatcher.

#include <cstddef>
#include <filesystem>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "db/store.hpp"
#include "server/jobs/dispatcher.hpp"
#include "server/jobs/executors/local_executor.hpp"
#include "server/jobs/executors/slurm/settings.hpp"
#include "server/jobs/job_limits.hpp"
#include "server/jobs/process.hpp"
#include "server/operate/data_folder.hpp"
#include "server/operate/metrics.hpp"
#include "server/operate/slots.hpp"

namespace leda::server {

enum class RunsOn { this_machine, slurm };

struct ServiceOptions {
  RunsOn runs_on = RunsOn::this_machine;
  std::size_t workers = 1;
  RunLimits run_limits;
  SlurmSettings slurm;
  std::filesystem::path program = program_beside();  ///< of the workers
  JobLimits limits;
};

struct Service {
  /// Opens the data folder and takes up what is unfinished.
  /// @throws DataFolderError, db::StoreError
  Service(const std::filesystem::path& data_folder, const ServiceOptions& options);

  const JobLimits limits;
  DataFolder data;
  RunnerLock lock;
  db::Store store;
  Metrics metrics;
  std::mutex submitting;  ///< one job is added at a time, so that a key is used once
  Slots layouts{limits.layouts};
  Dispatcher dispatcher;  ///< last: it uses all the others
};

/// What submit() says: the job, and whether it stood already (same key, same request).
struct Submitted {
  db::JobRecord job;
  bool stood_already = false;
};

/// Understands a request, finds every fault that can be known before a run, commits the job and
/// hands it to the dispatcher. Nothing changes where it throws.
/// @param request the execute request as sent
/// @param key of idempotency; empty: none
/// @throws Problem
Submitted submit(Service& service, const Process& process, const std::string& request,
                 const std::string& key);

/// What submit() would do: the sections and an estimate of their cost. Changes nothing, and is
/// refused where submit() would be.
/// @throws Problem
nlohmann::json dry_run(Service& service, const Process& process, const std::string& request);

/// Puts the failed sections of a finished job back in line. @throws Problem
db::JobStatus retry(Service& service, const std::string& id);

/// @throws Problem no_such_job
db::JobRecord job_or_problem(const db::Store& store, const std::string& id);
/// The same without reading its request. @throws Problem no_such_job
db::JobStatus job_status_or_problem(const db::Store& store, const std::string& id);

}  // namespace leda::server
