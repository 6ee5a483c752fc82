#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "server/commands/commands.hpp"
#include "server/commands/exit_code.hpp"
#include "server/commands/progress_line.hpp"
#include "server/commands/run_options.hpp"
#include "server/documents/execute_options.hpp"
#include "server/documents/process_ids.hpp"
#include "server/documents/region_request.hpp"
#include "server/http/handlers/section_document.hpp"
#include "server/jobs/service.hpp"
#include "server/layers/job_ensemble.hpp"
#include "server/layers/rasters.hpp"
#include "server/layers/section_table.hpp"
#include "server/operate/logging.hpp"
#include "server/operate/problem.hpp"
#include "server/run/interrupt_signals.hpp"
#include "server/run/run_folder.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

struct Options {
  std::filesystem::path request;
  std::filesystem::path data;
  WorkerOptions workers;
  int epsg = 0;
  std::string vertical_unit;
  std::string nodata;
  bool json = false;
};

/// A name for a DEM that comes as a file: its own, made to fit.
std::string raster_name_of(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  return is_raster_name(stem) ? stem : "dem";
}

/// A path is meant from here, or from beside the request.
/// @return empty where there is no such file
std::filesystem::path dem_file(const std::filesystem::path& named, const Options& options) {
  const auto beside = options.request.parent_path() / named;
  for (const auto& file : {named, beside}) {
    if (std::filesystem::is_regular_file(file)) return file;
  }
  return {};
}

/// What a registered raster is was said when it was registered.
void refuse_dem_options(const std::string& raster, const Options& options) {
  std::vector<Fault> faults;
  const auto refuse = [&](bool given, const char* name) {
    if (given) faults.push_back({name, "is of a file: '" + raster + "' is a registered raster"});
  };
  refuse(options.epsg != 0, "--epsg");
  refuse(!options.vertical_unit.empty(), "--vertical-unit");
  refuse(!options.nodata.empty(), "--nodata");
  if (faults.empty()) return;
  throw Problem(Failure::invalid_request, "leave out what a registered DEM cannot be told", faults);
}

/// Registers the DEM of a request that names a file.
/// @return the request with the DEM's id in its place
std::string with_registered_dem(Service& service, const std::string& text, const Options& options) {
  const auto request = parse_region_request(text, DemNaming::path_allowed);
  if (!request) {
    throw Problem(Failure::invalid_request, "the request cannot be understood", request.faults);
  }
  const std::string& named = request.value->dem;
  const auto known = service.store.raster(named);
  if (known && known->removed.empty()) {
    refuse_dem_options(named, options);
    return text;
  }
  const auto file = dem_file(named, options);
  if (file.empty()) {
    throw Problem(Failure::invalid_request, "there is no such DEM",
                  {{"/inputs/dem",
                    "is '" + named + "': there is no file of that name, neither here nor beside " +
                        options.request.filename().string() + ", and no registered raster"}});
  }
  RegisterOptions how;
  how.dem.epsg = options.epsg;
  how.dem.vertical_unit = options.vertical_unit;
  read_nodata(options.nodata, how);
  const auto raster = register_file(service.data, service.store, file, raster_name_of(file), how);
  for (const auto& warning : raster.warnings) {
    fmt::print(stderr, "warning: {}: {}\n", file.string(), warning);
  }
  json document = json::parse(text);
  document["inputs"]["dem"] = raster.id;
  return document.dump();
}

/// The job of this very request where it is unfinished: an earlier command was interrupted, and the
/// service has taken the job up.
/// @return empty where there is none
std::string unfinished_job_of(const db::Store& store, const std::string& request) {
  for (const auto& unfinished : store.unfinished_jobs()) {
    if (unfinished.process != map_region_id) continue;
    if (store.job(unfinished.id).value().request == request) return unfinished.id;
  }
  return "";
}

/// Goes on with the unfinished job of a request, or submits it. @return the job's id
std::string job_of(Service& service, const std::string& request) {
  const std::string unfinished = unfinished_job_of(service.store, request);
  if (unfinished.empty()) return submit(service, *find_process(map_region_id), request, "").job.id;
  fmt::print(stderr, "goes on with job {}, which is of the same request and unfinished\n",
             unfinished);
  return unfinished;
}

/// Waits for the end of a job, or for a signal.
db::JobStatus follow(const Service& service, const std::string& id) {
  ProgressLine line;
  for (;;) {
    auto job = job_status_or_problem(service.store, id);
    const std::string so_far = fmt::format("{:3d} %  {}", job.progress, job.message);
    line.show(so_far);
    if (db::is_final(job.state) || InterruptSignals::arrived()) {
      line.end_with(so_far);
      return job;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
}

int map_region(const Options& options) {
  set_up_logging(true);
  Service service(options.data, service_options(options.workers));
  const std::string request = with_registered_dem(service, read_whole(options.request), options);
  if (execute_options_of(request).dry_run) {
    fmt::print("{}\n", dry_run(service, *find_process(map_region_id), request).dump(2));
    return 0;
  }
  const InterruptSignals signals;
  const auto job = follow(service, job_of(service, request));
  if (!db::is_final(job.state)) {
    fmt::print(stderr, "interrupted; the same command continues job {}\n", job.id);
    return int(ExitCode::interrupted);
  }
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
    fmt::print("{}{}{}\n{} {}\n", section_table(sections),
               quantile_table(ensembles_of(service.store, job, sections)), job.message,
               db::to_string(job.state), job.id);
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
  command->add_option("--epsg", options->epsg, "code of the DEM's CRS, where its file does not say")
      ->check(CLI::Range(1024, 999'999));
  command
      ->add_option("--vertical-unit", options->vertical_unit,
                   "of the DEM's elevations, where its file does not say")
      ->check(CLI::IsMember({"m", "ft", "us-ft"}));
  command->add_option("--nodata", options->nodata,
                      "value of the DEM's cells without data, where its file does not say; none: "
                      "every value is ground");
  command->add_flag("--json", options->json, "machine-readable output");
  add_worker_options(*command, options->workers);
  command->callback(
      [options, &exit_code] { exit_code = guarded([&] { return map_region(*options); }); });
}

}  // namespace leda::server
