// The program `leda`. A region starts `leda simulate` for each of its sections, so that command
// stands here by itself and loads none of the hundred libraries that GDAL brings along; any other
// command is handed to leda-commands, which stands beside this program and has all of them.

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "server/commands/commands.hpp"
#include "server/commands/exit_code.hpp"

namespace {

int simulate(int argc, char** argv) {
  CLI::App app("Leda maps the hazard of retrogressive landslides in sensitive clays.", "leda");
  app.require_subcommand(1);
  int exit_code = 0;
  leda::server::add_simulate(app, exit_code);
  return leda::server::exit_code_of(app, argc, argv, exit_code);
}

int hand_over(char** argv) {
  const auto own = std::filesystem::read_symlink("/proc/self/exe");
  const auto all = own.parent_path() / "leda-commands";
  execv(all.c_str(), argv);
  fmt::print(stderr, "error: {}: {}; it belongs beside {}\n", all.string(), std::strerror(errno),
             own.string());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  const bool simulates = argc > 1 && std::string_view(argv[1]) == "simulate";
  return leda::server::guarded([&] { return simulates ? simulate(argc, argv) : hand_over(argv); });
}
