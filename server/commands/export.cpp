#include <fmt/format.h>

#include "server/commands/commands.hpp"
#include "server/commands/exit_code.hpp"
#include "server/jobs/service.hpp"
#include "server/layers/region_layers.hpp"
#include "server/operate/logging.hpp"

namespace leda::server {
namespace {

struct Options {
  std::string job;
  std::filesystem::path data;
  std::string format = "gpkg";
  std::filesystem::path out;
};

int export_job(const Options& options) {
  set_up_logging(true);
  const DataFolder data(options.data);
  const db::Store store(data.store());
  const auto job = job_or_problem(store, options.job);
  const auto format = profiles::export_format_from(options.format).value();
  profiles::export_layers(region_layers(store, job), format, options.out);
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
  command->add_option("--format", options->format, "what kind of file")
      ->check(CLI::IsMember({"gpkg", "geojson", "shp", "fgb"}))
      ->capture_default_str();
  command->add_option("--out", options->out, "the file")->required();
  command->callback(
      [options, &exit_code] { exit_code = guarded([&] { return export_job(*options); }); });
}

}  // namespace leda::server
