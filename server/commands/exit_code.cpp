#include "server/commands/exit_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "server/http/auth.hpp"
#include "server/http/http_server.hpp"
#include "server/operate/problem.hpp"

namespace leda::server {

int guarded(const std::function<int()>& command) {
  try {
    return command();
  } catch (const Problem& problem) {
    fmt::print(stderr, "error: {}\n", problem.what());
    for (const auto& fault : problem.faults) {
      fmt::print(stderr, "  {}: {}\n", fault.pointer, fault.message);
    }
    return is_ours(problem.failure) ? 1 : 2;
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

namespace {

/// Letters to insert, drop, change or swap with the next (Damerau's distance).
std::size_t typing_errors(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

/// Says what an unknown command may have been. False where the command is known.
bool refuse_unknown_command(CLI::App& app, int argc, char** argv) {
  const std::string given = argc > 1 ? argv[1] : "";
  if (given.empty() || given.starts_with('-')) return false;
  std::string nearest;
  std::size_t fewest = 3;  // more is another word
  for (const CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) {
    const std::size_t errors = typing_errors(given, command->get_name());
    if (errors == 0) return false;
    if (errors < fewest) nearest = command->get_name();
    fewest = std::min(fewest, errors);
  }
  fmt::print(stderr, "error: there is no command '{}'{}; leda --help lists them\n", given,
             nearest.empty() ? "" : ": did you mean '" + nearest + "'?");
  return true;
}

}  // namespace

int exit_code_of(CLI::App& app, int argc, char** argv, const int& of_command) {
  if (refuse_unknown_command(app, argc, argv)) return 2;
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return of_command;
}

}  // namespace leda::server
