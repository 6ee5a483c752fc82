#include <fmt/format.h>

#include <variant>

#include "server/commands/commands.hpp"
#include "server/commands/exit_code.hpp"
#include "server/jobs/service.hpp"
#include "server/layers/probability_rasters.hpp"
#include "server/layers/region_layers.hpp"
#include "server/operate/logging.hpp"
#include "server/operate/problem.hpp"

namespace leda::server {
namespace {

struct Options {
  std::string job;
  std::filesystem::path data;
  std::string format;  ///< empty: as the ending of the file says
  std::filesystem::path out;
};

/// The format of a file's ending: zones.gpkg, zones.shp.zip.
std::optional<profiles::ExportFormat> format_of_ending(const std::filesystem::path& file) {
  for (const auto format : profiles::all_export_formats) {
    if (file.filename().string().ends_with(profiles::file_ending(format))) return format;
  }
  return std::nullopt;
}

/// A file whose name says one thing and whose bytes another opens in no program.
profiles::ExportFormat format_or_problem(const Options& options) {
  const auto of_ending = format_of_ending(options.out);
  const auto wanted = profiles::export_format_from(options.format);
  const bool zip = wanted && options.out.extension() == ".zip" &&
                   std::string_view(profiles::file_ending(*wanted)).ends_with(".zip");
  if (zip && !of_ending) return *wanted;
  if (of_ending && (!wanted || *wanted == *of_ending)) return *of_ending;
  const std::string name = options.out.filename().string();
  if (wanted) {
    throw Problem(Failure::invalid_parameter,
                  fmt::format("--out is {}: a file of --format {} ends in {}", name, options.format,
                              profiles::file_ending(*wanted)));
  }
  throw Problem(
      Failure::invalid_parameter,
      "--out is " + name +
          ": give it the ending .gpkg, .geojson, .shp.zip, .fgb.zip or .tif of what it is "
          "to hold");
}

/// A raster says by its name which it is. @throws Problem where it does not
ZoneKind raster_kind_or_problem(const Options& options) {
  const std::string name = options.out.filename().string();
  if (const auto kind = raster_kind_from(name)) return *kind;
  throw Problem(Failure::invalid_parameter, "--out is " + name + ": a raster is named " +
                                                raster_name(ZoneKind::release) + " or " +
                                                raster_name(ZoneKind::runout));
}

/// Layers in a format, or a raster of a kind.
using Wanted = std::variant<profiles::ExportFormat, ZoneKind>;

Wanted wanted_or_problem(const Options& options) {
  if (options.out.extension() == ".tif" || options.format == "tif") {
    return raster_kind_or_problem(options);
  }
  return format_or_problem(options);
}

int export_job(const Options& options) {
  set_up_logging(true);
  const DataFolder data(options.data);
  const db::Store store(data.store());
  const auto job = job_status_or_problem(store, options.job);
  const Wanted wanted = wanted_or_problem(options);
  if (job.state != db::JobState::successful) {
    throw Problem(Failure::result_not_ready, "job " + job.id + " is " + db::to_string(job.state) +
                                                 (job.message.empty() ? "" : ": " + job.message) +
                                                 "; only a successful job is exported");
  }
  if (const auto* kind = std::get_if<ZoneKind>(&wanted)) {
    write_probability_raster(data, store, job, *kind, options.out);
  } else {
    profiles::export_layers(region_layers(store, job), std::get<profiles::ExportFormat>(wanted),
                            options.out);
  }
  fmt::print("{}\n", options.out.string());
  return 0;
}

}  // namespace

void add_export(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("export", "Sections and zones of a job to a file");
  command->add_option("job", options->job, "id of the job")->required();
  command->add_option("--data", options->data, "data folder")
      ->required()
      ->check(CLI::ExistingDirectory);
  command
      ->add_option("--format", options->format,
                   "what kind of file, where its ending is to be checked against it")
      ->check(CLI::IsMember({"gpkg", "geojson", "shp", "fgb", "tif"}));
  command
      ->add_option("--out", options->out,
                   "the file; .gpkg, .geojson, .shp.zip or .fgb.zip says what kind, "
                   "release_probability.tif or runout_probability.tif which raster")
      ->required();
  command->callback(
      [options, &exit_code] { exit_code = guarded([&] { return export_job(*options); }); });
}

}  // namespace leda::server
