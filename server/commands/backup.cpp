#include <fmt/format.h>

#include "server/commands/commands.hpp"
#include "server/commands/exit_code.hpp"
#include "server/operate/logging.hpp"
#include "server/operate/retention.hpp"

namespace leda::server {
namespace {

struct Options {
  std::filesystem::path data;
  std::filesystem::path out;
  bool without_fields = false;
};

int back_up_data(const Options& options) {
  set_up_logging(true);
  const DataFolder data(options.data);
  const BackedUp done = back_up(data, options.out, !options.without_fields);
  fmt::print("{}: the store, {} DEMs, {} run folders, {:.1f} MB\n", options.out.string(),
             done.rasters, done.run_folders, static_cast<double>(done.bytes) / 1e6);
  return 0;
}

}  // namespace

void add_backup(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "backup", "Copy a data folder, also while a server works in it; the copy can be served");
  command->add_option("--data", options->data, "data folder")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->add_option("--out", options->out, "folder of the copy; must not exist")->required();
  command->add_flag("--without-fields", options->without_fields,
                    "leave out fields.h5 and the ParaView files, most of the bytes");
  command->callback(
      [options, &exit_code] { exit_code = guarded([&] { return back_up_data(*options); }); });
}

}  // namespace leda::server
