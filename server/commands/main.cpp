// leda-commands, the whole command line of Leda: `leda` hands it all but `simulate`. Each
// subcommand stands in a file of its own.

#include "server/commands/commands.hpp"
#include "server/commands/exit_code.hpp"
#include "server/operate/version.hpp"

namespace {

int run(int argc, char** argv) {
  CLI::App app("Leda maps the hazard of retrogressive landslides in sensitive clays.", "leda");
  app.set_version_flag("--version", std::string("leda ") + leda::server::version());
  app.require_subcommand(1);
  int exit_code = 0;
  leda::server::add_serve(app, exit_code);
  leda::server::add_map(app, exit_code);
  leda::server::add_simulate(app, exit_code);
  leda::server::add_screen(app, exit_code);
  leda::server::add_dss(app, exit_code);
  leda::server::add_calibrate(app, exit_code);
  leda::server::add_fit(app, exit_code);
  leda::server::add_compare(app, exit_code);
  leda::server::add_ensemble(app, exit_code);
  leda::server::add_hindcast(app, exit_code);
  leda::server::add_study(app, exit_code);
  leda::server::add_check(app, exit_code);
  leda::server::add_export(app, exit_code);
  leda::server::add_backup(app, exit_code);
  leda::server::add_purge(app, exit_code);
  leda::server::add_array_task(app, exit_code);
  leda::server::add_token(app, exit_code);
  return leda::server::exit_code_of(app, argc, argv, exit_code);
}

}  // namespace

int main(int argc, char** argv) {
  return leda::server::guarded([&] { return run(argc, argv); });
}
