#include <fmt/format.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <new>
#include <stdexcept>

#include "server/commands/commands.hpp"
#include "server/commands/exit_code.hpp"
#include "server/commands/folder_option.hpp"
#include "server/commands/progress_line.hpp"
#include "server/documents/result_document.hpp"
#include "server/documents/warning_lines.hpp"
#include "server/run/interrupt_signals.hpp"
#include "server/run/run_folder.hpp"

namespace leda::server {
namespace {

struct Options {
  std::filesystem::path case_file;
  std::filesystem::path out;
  bool json = false;
  bool no_progress = false;
  bool keep_checkpoint = false;
  double checkpoint_interval_s = RunOptions{}.checkpoint_interval_s;
  std::string precision = "single";
  bool no_rest = false;
  bool full = false;
  int threads = 1;
};

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in.good() && !in.eof()) throw std::runtime_error(file.string() + " cannot be read");
  return text;
}

std::string text_of(const solver::Progress& p) {
  return fmt::format("{:3.0f} %  {}, {:.1f} s", 100 * p.fraction, p.stage, p.time_s);
}

void print_summary(const SectionResult& r, const std::filesystem::path& out) {
  fmt::print("{}{}{}\n", to_string(r.status), r.reason.empty() ? "" : ": ", r.reason);
  const auto at_least = [](Bound is) { return is == Bound::lower_bound ? "at least " : ""; };
  fmt::print("retrogression {}{:.1f} m, runout {}{:.1f} m from the toe, {:.1f} m from the crest\n",
             at_least(r.retrogression_is), r.crest_to_crest_retrogression_m, at_least(r.runout_is),
             r.runout_m, r.runout_from_crest_m);
  fmt::print("trigger {}, {} slides, {:.1f} s simulated in {:.1f} s\n", r.trigger_used, r.slides,
             r.simulated_s, r.run_time_s);
  fmt::print("{} particles, {} steps, {:.1f} ns a particle and step\n", r.particles, r.steps,
             r.ns_per_particle_step);
  fmt::print("{}", warning_lines(r.warnings));
  fmt::print("{}\n", (out / "result.json").string());
}

/// Runs the case. What a server has to tell apart has an exit code of its own.
RunOutcome run(const Options& options, const RunOptions& run_options) {
  RunOutcome outcome;
  try {
    return run_case(text_of(options.case_file), options.out, run_options);
  } catch (const std::bad_alloc&) {
    outcome.code = ExitCode::out_of_memory;
    rlimit limit{};
    getrlimit(RLIMIT_AS, &limit);
    fmt::print(
        stderr, "error: the run needs more memory than {}\n",
        limit.rlim_cur == RLIM_INFINITY
            ? "there is"
            : fmt::format("the {:.3g} GB it may use", static_cast<double>(limit.rlim_cur) / 1e9));
  } catch (const std::exception& error) {
    if (!disk::tells_of_full_disk(error)) throw;
    outcome.code = ExitCode::disk_full;
    fmt::print(stderr, "error: {}\n", error.what());
  }
  return outcome;
}

int simulate(const Options& options) {
  const InterruptSignals signals;
  // A limit on the size of files then tells itself as an error, like a full disk.
  static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
  ProgressLine progress(options.no_progress);
  RunOptions run_options;
  run_options.precision =
      options.full ? Precision::double_precision : precision_from(options.precision).value();
  run_options.ground_rests = !options.full && !options.no_rest;
  run_options.threads = options.threads;
  run_options.interrupted = InterruptSignals::arrived;
  run_options.say = [](const std::string& line) { fmt::print(stderr, "{}\n", line); };
  run_options.keep_checkpoint = options.keep_checkpoint;
  run_options.checkpoint_interval_s = options.checkpoint_interval_s;
  std::string so_far;
  run_options.progress = [&](const solver::Progress& p) { progress.show(so_far = text_of(p)); };
  const RunOutcome outcome = run(options, run_options);
  progress.end_with(so_far);

  for (const Fault& fault : outcome.faults) {
    fmt::print(stderr, "{}: {}\n", fault.pointer.empty() ? "/" : fault.pointer, fault.message);
  }
  if (outcome.code == ExitCode::interrupted) {
    fmt::print(stderr, "interrupted, no result yet; the same command continues from {}\n",
               options.out.string());
  }
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
      ->required()
      ->check(no_folder);
  command->add_flag("--json", options->json, "print result.json");
  command->add_flag("--no-progress", options->no_progress,
                    "no progress on standard error; DIR/progress.json has it");
  command
      ->add_option("--checkpoint-interval-s", options->checkpoint_interval_s,
                   "time between checkpoints, s")
      ->envname("LEDA_CHECKPOINT_INTERVAL_S")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command->add_flag("--keep-checkpoint", options->keep_checkpoint,
                    "leave the last checkpoint beside the result");
  command
      ->add_option("--threads", options->threads,
                   "cores for this one section; the result is the same for any number")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_option("--precision", options->precision, "of the moving stage: single or double")
      ->check(CLI::IsMember({"single", "double"}))
      ->capture_default_str();
  command->add_flag("--no-rest", options->no_rest, "also step ground that has come to rest");
  command->add_flag("--full", options->full,
                    "to compare with: --precision double and --no-rest together");
  command->footer(
      "Exit codes: 0 a result stands, 2 the case is invalid, 3 the run was unstable, "
      "4 interrupted (the same command continues), 5 the disk is full (the same), "
      "6 the run needs more memory than it may use.");
  command->callback(
      [options, &exit_code] { exit_code = guarded([&] { return simulate(*options); }); });
}

}  // namespace leda::server
