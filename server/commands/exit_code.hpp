#pragma once
// What a command leaves: faults on standard error, and an exit code.

#include <CLI/CLI.hpp>
#include <functional>

namespace leda::server {

/// Calls a command; what it throws is told on standard error, each fault with its pointer.
/// @return its exit code; 2 where the input is at fault, 1 after any other failure
int guarded(const std::function<int()>& command);

/// Reads the arguments, which runs the command they name.
/// @param of_command where the commands of `app` leave their exit code
/// @return that code; 2 where the arguments are at fault
int exit_code_of(CLI::App& app, int argc, char** argv, const int& of_command);

}  // namespace leda::server
