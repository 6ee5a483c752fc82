#include "server/commands/folder_runs.hpp"

#include <algorithm>
#include <thread>

#include "server/commands/folder_option.hpp"
#include "server/operate/data_folder.hpp"
#include "server/run/run_folder.hpp"

namespace leda::server {

void add_folder_runs_options(CLI::App& command, FolderRunsOptions& options, const std::string& name,
                             const std::string& tells) {
  command.add_option("--out", options.out, "folder of the " + name + "; made where it is missing")
      ->required()
      ->check(no_folder);
  command.add_option("--workers", options.workers, "runs at the same time; 0: one a core")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command.add_flag("--keep-fields", options.keep_fields, "keep fields.h5 of every run");
  command.add_flag("--dry-run", options.dry_run, "check it, tell " + tells + ", and run nothing");
  command.add_flag("--json", options.json, "print " + name + ".json, or the dry run as JSON");
}

std::size_t workers_or_cores(std::size_t wanted) {
  return wanted > 0 ? wanted : std::max(1U, std::thread::hardware_concurrency());
}

CaseReader cases_beside(const std::filesystem::path& document) {
  return [folder = document.parent_path()](const std::string& name) {
    try {
      return std::optional(read_whole(folder / name));
    } catch (const DataFolderError&) {
      return std::optional<std::string>();
    }
  };
}

}  // namespace leda::server
