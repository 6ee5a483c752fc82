// leda check: stiff and extreme cases, each held to what it promises.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "server/commands/check_report.hpp"
#include "server/commands/commands.hpp"
#include "server/commands/exit_code.hpp"
#include "server/operate/data_folder.hpp"
#include "server/run/interrupt_signals.hpp"
#include "server/run/run_folder.hpp"
#include "solver/extremes/suite.hpp"
#include "solver/extremes/try_case.hpp"

namespace leda::server {
namespace {

constexpr const char* footer = R"(
Every case promises that no value of a frame or a result is ever anything but a finite number, that
mass and momentum are kept, and what stands with it in solver/extremes/suite.cpp: how it ends, how
large its energy error may be, a band, or likeness to another case. R is the retrogression and L
the runout; gH/su is the stability number from which a vertical cut fails.
Exit codes: 0 every promise was kept, 1 one was broken, 2 the command is wrong, 4 interrupted.)";

struct Options {
  bool quick = false;
  std::vector<std::string> only;
  std::filesystem::path json_file, csv_file;
};

/// For the command line: empty where there is such a case.
std::string fault_of_name(const std::string& name) {
  std::string known;
  for (const auto& c : solver::extreme_suite()) {
    if (c.name == name) return {};
    known += (known.empty() ? "" : ", ") + c.name;
  }
  return "no case " + name + "; there are " + known;
}

/// The cases asked for and those they are compared with.
std::vector<solver::ExtremeCase> asked_for(const Options& options) {
  if (options.only.empty()) {
    return options.quick ? solver::quick_extreme_suite() : solver::extreme_suite();
  }
  auto suite = solver::extreme_suite();
  std::vector<std::string> names = options.only;
  for (const auto& c : suite) {
    if (std::ranges::count(options.only, c.name) > 0) names.push_back(c.promise.like);
  }
  std::erase_if(suite, [&](const auto& c) { return std::ranges::count(names, c.name) == 0; });
  return suite;
}

void leave(const Options& options, const std::vector<solver::Outcome>& outcomes) {
  if (!options.csv_file.empty()) disk::write_whole(options.csv_file, check_csv(outcomes));
  if (!options.json_file.empty()) {
    disk::write_whole(options.json_file, check_document(outcomes).dump(2) + "\n");
  }
}

int run(const Options& options) {
  const auto suite = asked_for(options);
  const InterruptSignals signals;
  const bool terminal = isatty(STDERR_FILENO) != 0;
  std::vector<solver::Outcome> outcomes;
  fmt::print("{}", check_header());
  for (const auto& extreme : suite) {
    if (terminal)
      fmt::print(stderr, "{} of {}: {} ", outcomes.size() + 1, suite.size(), extreme.name);
    solver::Outcome outcome = solver::try_case(extreme, outcomes, InterruptSignals::arrived);
    if (terminal) fmt::print(stderr, "\r\033[K");
    if (InterruptSignals::arrived()) {
      fmt::print(stderr, "interrupted in {}\n", extreme.name);
      return int(ExitCode::interrupted);
    }
    fmt::print("{}", check_line(outcome));
    static_cast<void>(std::fflush(stdout));
    outcomes.push_back(std::move(outcome));
  }
  leave(options, outcomes);
  const auto broken = std::ranges::count_if(outcomes, [](const auto& o) { return !o.kept(); });
  fmt::print("{} cases, {} with a broken promise\n", outcomes.size(), broken);
  return broken == 0 ? int(ExitCode::result) : int(ExitCode::failure);
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("check", "Stiff and extreme cases, each held to what it promises");
  command->add_flag("--quick", options->quick, "the cases that take seconds only");
  command->add_option("--case", options->only, "only these cases, by name")->check(fault_of_name);
  command->add_option("--json", options->json_file, "also write the table as JSON");
  command->add_option("--csv", options->csv_file, "also write the table as CSV");
  command->footer(footer);
  command->callback([options, &exit_code] { exit_code = guarded([&] { return run(*options); }); });
}

}  // namespace leda::server
