#pragma once
// The options of a command from a file of settings.

#include <CLI/CLI.hpp>

namespace leda::server {

/// Adds --settings FILE to a command: TOML, where `most_jobs = 5` is --most-jobs 5, and `partition`
/// under [slurm] is --slurm-partition. What the command line or the environment says wins. Has to
/// be the command's first option. An unknown setting, or a value that its option refuses, ends the
/// command; all of them are named at once.
void add_settings_file(CLI::App& command);

}  // namespace leda::server
