#include <fmt/format.h>

#include "server/commands/commands.hpp"
#include "server/commands/exit_code.hpp"
#include "server/operate/logging.hpp"
#include "server/operate/retention.hpp"

namespace leda::server {
namespace {

struct Options {
  std::filesystem::path data;
  double days = 0;
  bool with_jobs = false;
};

int purge_data(const Options& options) {
  set_up_logging(true);
  const DataFolder data(options.data);
  const RunnerLock lock(data);  // a server that runs is asked instead: POST /purge
  db::Store store(data.store());
  const Purged purged = purge(data, store, options.days, options.with_jobs);
  fmt::print("removed {} run folders and {} jobs, {:.1f} MB\n", purged.run_folders, purged.jobs,
             static_cast<double>(purged.bytes) / 1e6);
  return 0;
}

}  // namespace

void add_purge(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "purge", "Remove what old jobs left; while a server runs, POST /purge does the same");
  command->add_option("--data", options->data, "data folder")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->add_option("--older-than-days", options->days, "jobs that ended before")
      ->required()
      ->check(CLI::Range(0.0, 1e5));
  command->add_flag("--jobs", options->with_jobs,
                    "the jobs with their results too, not only run folders and exports");
  command->callback(
      [options, &exit_code] { exit_code = guarded([&] { return purge_data(*options); }); });
}

}  // namespace leda::server
