#pragma once
// One function a subcommand of `leda`: it adds itself to the command line and, when called,
// leaves the exit code of the program.

#include <CLI/CLI.hpp>

namespace leda::server {

void add_serve(CLI::App& app, int& exit_code);
void add_map(CLI::App& app, int& exit_code);
void add_simulate(CLI::App& app, int& exit_code);
void add_compare(CLI::App& app, int& exit_code);
void add_export(CLI::App& app, int& exit_code);
void add_screen(CLI::App& app, int& exit_code);
void add_dss(CLI::App& app, int& exit_code);
void add_calibrate(CLI::App& app, int& exit_code);
void add_fit(CLI::App& app, int& exit_code);
void add_ensemble(CLI::App& app, int& exit_code);
void add_hindcast(CLI::App& app, int& exit_code);
void add_study(CLI::App& app, int& exit_code);
void add_check(CLI::App& app, int& exit_code);
void add_backup(CLI::App& app, int& exit_code);
void add_purge(CLI::App& app, int& exit_code);
void add_array_task(CLI::App& app, int& exit_code);
void add_token(CLI::App& app, int& exit_code);

}  // namespace leda::server
