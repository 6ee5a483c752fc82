#include <fmt/format.h>

#include "server/commands/commands.hpp"
#include "server/commands/exit_code.hpp"
#include "server/documents/compare_document.hpp"
#include "server/jobs/service.hpp"
#include "server/layers/compare_sections.hpp"
#include "server/layers/section_table.hpp"
#include "server/operate/logging.hpp"
#include "server/run/run_folder.hpp"

namespace leda::server {
namespace {

struct Options {
  std::string job;
  std::vector<std::string> sections;
  std::filesystem::path data;
  std::filesystem::path svg;
  bool json = false;
};

std::string number_of(const nlohmann::json& difference, const char* key) {
  const auto& value = difference[key];
  if (value.is_number()) return fmt::format("{:+.1f} m", value.get<double>());
  return fmt::format("unknown ({})", difference["unknown"][key].get<std::string>());
}

/// "BB' against AA': retrogression -0.7 m, runout unknown (that of AA' is a lower bound)"
std::string sentence(const nlohmann::json& difference) {
  return fmt::format("{} against {}: retrogression {}, runout {}",
                     difference["to"].get<std::string>(), difference["from"].get<std::string>(),
                     number_of(difference, "crest_to_crest_retrogression_m"),
                     number_of(difference, "runout_m"));
}

int compare(const Options& options) {
  set_up_logging(true);
  const DataFolder data(options.data);
  const db::Store store(data.store());
  const auto records = sections_or_problem(store, options.job, options.sections);
  const auto compared = as_compared(records);
  if (!options.svg.empty()) disk::write_whole(options.svg, compare_svg(compared));
  if (options.json) {
    fmt::print("{}\n", compare_json(compared).dump(2));
    return 0;
  }
  fmt::print("{}", section_table(records));
  const auto document = compare_json(compared);
  for (const auto& difference : document["differences"]) fmt::print("{}\n", sentence(difference));
  return 0;
}

}  // namespace

void add_compare(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("compare", "Sections of a job side by side");
  command->add_option("job", options->job, "id of the job")->required();
  command->add_option("sections", options->sections, "names of two sections or more")
      ->required()
      ->expected(2, 20);
  command->add_option("--data", options->data, "data folder")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->add_option("--svg", options->svg, "also write a drawing");
  command->add_flag("--json", options->json, "machine-readable output");
  command->callback(
      [options, &exit_code] { exit_code = guarded([&] { return compare(*options); }); });
}

}  // namespace leda::server
