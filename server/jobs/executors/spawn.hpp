#pragma once
// Another program, started with a list of arguments (never a shell), and what it said.

#include <atomic>
#include <chrono>
#include <string>
#include <vector>

namespace leda::server {

struct Said {
  bool ended = false;  ///< by itself and in time; false: it could not be started, or was ended
  int exit_code = -1;  ///< where it ended; 128 + N after signal N
  std::string out;     ///< standard output
  std::string errors;  ///< standard error, or why it could not be started
};

/// Runs a program to its end. Its standard input is empty, and it inherits no open file.
/// @param arguments the program first; without a slash it is looked up in PATH
/// @param patience after that it is ended with SIGKILL
/// @param stop ends it sooner when it becomes true
Said ask_program(std::vector<std::string> arguments, std::chrono::milliseconds patience,
                 const std::atomic<bool>& stop);

}  // namespace leda::server
