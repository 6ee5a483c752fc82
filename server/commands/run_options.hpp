#pragma once
// How runs are computed: the options that serve and map share.

#include <CLI/CLI.hpp>
#include <string>

#include "server/jobs/service.hpp"

namespace leda::server {

struct WorkerOptions {
  std::size_t workers = 0;  ///< 0: one a core
  std::string executor = "local";
  double memory_GB = 8;
  double time_limit_s = 8 * 3600;
  SlurmSettings slurm;
  double slurm_look_every_s = 5;
  double slurm_settle_s = 30;
};

void add_worker_options(CLI::App& command, WorkerOptions& options);

/// @throws std::runtime_error with every setting that can't work
ServiceOptions service_options(const WorkerOptions& options);

}  // namespace leda::server
