#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "server/commands/commands.hpp"
#include "server/commands/exit_code.hpp"
#include "server/documents/interrupt_signals.hpp"
#include "server/documents/result_document.hpp"
#include "server/documents/run_folder.hpp"

namespace leda::server {
namespace {

struct Options {
  std::filesystem::path case_file;
  std::filesystem::path out;
  bool json = false;
};

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in.good() && !in.eof()) throw std::runtime_error(file.string() + " cannot be read");
  return text;
}

void show_progress(const solver::Progress& p) {
  fmt::print(stderr, "\r\033[K{:3.0f} %  {}, {:.1f} s", 100 * p.fraction, p.stage, p.time_s);
}

void print_summary(const SectionResult& r, const std::filesystem::path& out) {
  fmt::print("{}{}{}\n", to_string(r.status), r.reason.empty() ? "" : ": ", r.reason);
  fmt::print("retrogression {:.1f} m, runout {:.1f} m from the toe, {:.1f} m from the crest\n",
             r.crest_to_crest_retrogression_m, r.runout_m, r.runout_from_crest_m);
  fmt::print("trigger {}, {} slides, {:.1f} s simulated in {:.1f} s\n", r.trigger_used, r.slides,
             r.simulated_s, r.run_time_s);
  fmt::print("{} particles, {} steps, {:.1f} ns a particle and step\n", r.particles, r.steps,
             r.ns_per_particle_step);
  for (const std::string& warning : r.warnings) fmt::print("warning: {}\n", warning);
  fmt::print("{}\n", (out / "result.json").string());
}

int simulate(const Options& options) {
  const InterruptSignals signals;
  const bool terminal = !options.json && isatty(STDERR_FILENO) != 0;
  RunOptions run;
  run.interrupted = InterruptSignals::arrived;
  if (terminal) run.progress = show_progress;
  const RunOutcome outcome = run_case(text_of(options.case_file), options.out, run);
  if (terminal && outcome.code != ExitCode::invalid) fmt::print(stderr, "\n");

  for (const Fault& fault : outcome.faults) {
    fmt::print(stderr, "{}: {}\n", fault.pointer.empty() ? "/" : fault.pointer, fault.message);
  }
  if (outcome.code == ExitCode::interrupted) fmt::print(stderr, "interrupted, no result\n");
  if (outcome.result && options.json) fmt::print("{}", result_text(*outcome.result));
  if (outcome.result && !options.json) print_summary(*outcome.result, options.out);
  return int(outcome.code);
}

}  // namespace

void add_simulate(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("simulate", "Run one section; leaves result.json in DIR");
  command->add_option("case", options->case_file, "CASE.json")
      ->required()
      ->check(CLI::ExistingFile);
  command->add_option("--out", options->out, "folder of the result; made where it is missing")
      ->required();
  command->add_flag("--json", options->json, "print result.json");
  command->footer(
      "Exit codes: 0 a result stands, 2 the case is invalid, 3 the run was unstable, "
      "4 interrupted.");
  command->callback(
      [options, &exit_code] { exit_code = guarded([&] { return simulate(*options); }); });
}

}  // namespace leda::server
