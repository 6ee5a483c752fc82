#pragma once
// What commands share that run many cases in a folder: study, ensemble and hindcast.

#include <CLI/CLI.hpp>
#include <cstddef>
#include <filesystem>
#include <string>

#include "server/documents/named_case.hpp"
#include "server/jobs/case_runs.hpp"

namespace leda::server {

struct FolderRunsOptions {
  std::filesystem::path out;
  std::size_t workers = 0;  ///< 0: one a core
  bool keep_fields = false;
  bool dry_run = false;
  bool json = false;

  Fields fields() const { return keep_fields ? Fields::kept : Fields::removed; }
};

/// @param name of what is left in the folder: "ensemble"
/// @param tells of the dry run: "members, runs and core-hours"
void add_folder_runs_options(CLI::App& command, FolderRunsOptions& options, const std::string& name,
                             const std::string& tells);

/// So many workers; 0: one a core.
std::size_t workers_or_cores(std::size_t wanted);

/// Reads the case files that a document names, from the folder it stands in.
CaseReader cases_beside(const std::filesystem::path& document);

}  // namespace leda::server
