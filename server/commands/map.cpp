#include <fmt/format.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "server/commands/commands.hpp"
#include "server/commands/exit_code.hpp"
#include "server/commands/run_options.hpp"
#include "server/documents/execute_options.hpp"
#include "server/documents/region_request.hpp"
#include "server/http/handlers/section_document.hpp"
#include "server/http/problem.hpp"
#include "server/jobs/service.hpp"
#include "server/layers/rasters.hpp"
#include "server/layers/section_table.hpp"
#include "server/operate/logging.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

struct Options {
  std::filesystem::path request;
  std::filesystem::path data;
  WorkerOptions workers;
  bool json = false;
};

/// A name for a DEM that comes as a file: its own, made to fit.
std::string raster_name_of(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  return is_raster_name(stem) ? stem : "dem";
}

/// Registers the DEM of a request that names a file.
/// @return the request with the DEM's id in its place
std::string with_registered_dem(Service& service, const std::string& text) {
  const auto request = parse_region_request(text, DemNaming::path_allowed);
  if (!request) {
    throw Problem(Failure::invalid_request, "the request cannot be understood", request.faults);
  }
  const std::filesystem::path file = request.value->dem;
  if (service.store.raster(request.value->dem) || !std::filesystem::is_regular_file(file)) {
    return text;
  }
  const auto raster = register_file(service.data, service.store, file, raster_name_of(file));
  json document = json::parse(text);
  document["inputs"]["dem"] = raster.id;
  return document.dump();
}

bool is_finished(const db::JobRecord& job) {
  return job.state != db::JobState::accepted && job.state != db::JobState::running;
}

/// Waits for the end of a job; shows how far it is where somebody looks.
db::JobRecord follow(const Service& service, const std::string& id, bool silent) {
  const bool terminal = !silent && isatty(STDERR_FILENO) != 0;
  for (;;) {
    auto job = job_or_problem(service.store, id);
    if (terminal) fmt::print(stderr, "\r\033[K{:3d} %  {}", job.progress, job.message);
    if (is_finished(job)) {
      if (terminal) fmt::print(stderr, "\n");
      return job;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
}

int map_region(const Options& options) {
  set_up_logging(true);
  Service service(options.data, service_options(options.workers));
  const std::string request = with_registered_dem(service, read_whole(options.request));
  if (execute_options_of(request).dry_run) {
    fmt::print("{}\n", dry_run(service, *find_process("map-region"), request).dump(2));
    return 0;
  }
  const auto submitted = submit(service, *find_process("map-region"), request, "");
  const auto job = follow(service, submitted.job.id, options.json);
  const auto sections = service.store.sections(job.id);
  if (options.json) {
    json rows = json::array();
    for (const auto& section : sections) rows.push_back(section_row(section));
    fmt::print("{}\n", json{{"job", job.id},
                            {"status", db::to_string(job.state)},
                            {"message", job.message},
                            {"sections", rows}}
                           .dump(2));
  } else {
    fmt::print("{}{}\n{} {}\n", section_table(sections), job.message, db::to_string(job.state),
               job.id);
  }
  return job.state == db::JobState::successful ? 0 : 1;
}

}  // namespace

void add_map(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("map", "Map a region; the last word printed is the job's id");
  command->add_option("request", options->request, "REGION.json, as for POST; dem may be a file")
      ->required()
      ->check(CLI::ExistingFile);
  command->add_option("--data", options->data, "data folder")->required();
  command->add_flag("--json", options->json, "machine-readable output");
  add_worker_options(*command, options->workers);
  command->callback(
      [options, &exit_code] { exit_code = guarded([&] { return map_region(*options); }); });
}

}  // namespace leda::server
