#pragma once
// How runs are computed: the options that serve and map share.

#include <CLI/CLI.hpp>
#include <string>

#include "server/service.hpp"

namespace leda::server {

struct WorkerOptions {
  std::size_t workers = 0;  ///< 0: one a core
  std::string executor = "local";
  double memory_GB = 8;
  double time_limit_s = 8 * 3600;
};

void add_worker_options(CLI::App& command, WorkerOptions& options);

ServiceOptions service_options(const WorkerOptions& options);

}  // namespace leda::server
