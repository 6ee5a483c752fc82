#include "server/commands/exit_code.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "server/http/auth.hpp"
#include "server/http/http_server.hpp"
#include "server/http/problem.hpp"

namespace leda::server {

int guarded(const std::function<int()>& command) {
  try {
    return command();
  } catch (const Problem& problem) {
    fmt::print(stderr, "error: {}\n", problem.what());
    for (const auto& fault : problem.faults) {
      fmt::print(stderr, "  {}: {}\n", fault.pointer, fault.message);
    }
    return status_of(problem.failure) < 500 ? 2 : 1;
  } catch (const ListenError& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  } catch (const TokenFileError& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 1;
  }
}

int exit_code_of(CLI::App& app, int argc, char** argv, const int& of_command) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return of_command;
}

}  // namespace leda::server
