// leda hindcast: what past slides teach.

#include <fmt/format.h>

#include "db/utc_now.hpp"
#include "disk/whole_file.hpp"
#include "server/commands/commands.hpp"
#include "server/commands/exit_code.hpp"
#include "server/commands/folder_runs.hpp"
#include "server/commands/progress_line.hpp"
#include "server/documents/hindcast_document.hpp"
#include "server/documents/member_warnings.hpp"
#include "server/documents/warning_lines.hpp"
#include "server/drawings/hindcast_drawing.hpp"
#include "server/jobs/executors/local_executor.hpp"
#include "server/jobs/hindcast_folder.hpp"
#include "server/jobs/run_size.hpp"
#include "server/operate/data_folder.hpp"
#include "server/operate/problem.hpp"
#include "server/operate/version.hpp"
#include "server/run/interrupt_signals.hpp"
#include "server/run/run_folder.hpp"

namespace leda::server {
namespace {

namespace fs = std::filesystem;

constexpr const char* footer = R"(
HINDCAST.json:
  {"name": "sensitive clay", "events": [
    {"name": "Saint-Jude", "case_file": "saint-jude.json", "observed": {
      "retrogression_m": {"value": 80, "sd_ln": 0.1}, "runout_m": {"at_least": 40}}}, ...],
   "ensemble": {"inputs": [
     {"name": "rate", "path": "/materials/*/rate/per_decade", "scope": "region",
      "distribution": {"type": "uniform", "min": 0.06, "max": 0.12}},
     {"name": "su", "path": "/materials/*/peak_strength_kPa", "apply": "scale",
      "distribution": {"type": "lognormal", "mean": 1, "cov": 0.15}}]},
   "discrepancy": {"sd_ln": 0.3, "correlation": 0.5}, "members": 64, "waves": 2}
Inputs of the scope region are the same at every slide, and learned; others are drawn by each slide.
case_file is relative to HINDCAST.json; "case" with a case in its place works too. Leaves
hindcast.json, members.csv and hindcast.svg in DIR, and the case and result of each run in
DIR/members. "posterior"/"inputs" of hindcast.json are inputs of an ensemble. A hindcast that was
interrupted or killed goes on where it was.
Exit codes: 0 the hindcast stands, 1 no member agrees with all slides, 2 it is invalid,
4 interrupted.)";

struct Options {
  fs::path file;
  FolderRunsOptions runs;
};

HindcastFile read_hindcast(const fs::path& file) {
  auto parsed = parse_hindcast_file(read_whole(file), cases_beside(file));
  if (!parsed) {
    throw Problem(Failure::invalid_request, "the hindcast cannot be understood", parsed.faults);
  }
  return std::move(*parsed.value);
}

/// What a wave costs whose members slide at once, core-seconds; one that stands costs little.
RunCost cost_of_wave(const HindcastFile& file) {
  RunCost all;
  const auto runs = static_cast<double>(file.plan.draws.members);
  for (const PastCase& slide : file.cases) {
    const RunCost one =
        cost_of(run_size(slide.of.section, slide.of.settings), typical_or_default(std::nullopt));
    all.likely_core_s += runs * one.likely_core_s;
    all.longest_core_s += runs * one.longest_core_s;
  }
  return all;
}

void show_dry_run(const HindcastFile& file, const std::vector<std::string>& warnings,
                  bool as_json) {
  const std::size_t runs = runs_of_draw(file.plan, 0, 0).size();
  const std::size_t most_runs = runs * file.plan.waves * file.plan.draws.locals;
  const auto waves = static_cast<double>(file.plan.waves);
  const RunCost wave = cost_of_wave(file);
  if (as_json) {
    const nlohmann::json estimate{
        {"runs_at_least", runs},
        {"runs_at_most", most_runs},
        {"core_hours_at_least", wave.likely_core_s / 3600},
        {"core_hours_at_most", waves * wave.likely_core_s / 3600},
        {"core_hours_if_none_comes_to_rest", waves * wave.longest_core_s / 3600}};
    fmt::print(
        "{}\n",
        nlohmann::json{{"dryRun", true}, {"warnings", warnings}, {"estimate", estimate}}.dump(2));
    return;
  }
  fmt::print("{} slides, {} to {} runs, {:.2g} to {:.2g} core-hours\n", file.cases.size(), runs,
             most_runs, wave.likely_core_s / 3600, waves * wave.likely_core_s / 3600);
}

void leave(const Hindcast& hindcast, const nlohmann::json& document, const fs::path& out) {
  disk::write_whole(out / "members.csv", members_csv(hindcast));
  disk::write_whole(out / "hindcast.svg", hindcast_svg(hindcast));
  disk::write_whole(out / "hindcast.json", document.dump(2) + "\n");
}

int run(const Options& options) {
  const HindcastFile asked = read_hindcast(options.file);
  const auto warnings = hindcast_warnings(asked, {}, 0);
  fmt::print(stderr, "{}", warning_lines(warnings));
  if (options.runs.dry_run) {
    show_dry_run(asked, warnings, options.runs.json);
    return int(ExitCode::result);
  }
  const InterruptSignals signals;
  ProgressLine line;
  fs::create_directories(options.runs.out);
  LocalExecutor executor(program_beside(), workers_or_cores(options.runs.workers));
  RunsListener listener;
  listener.interrupted = InterruptSignals::arrived;
  std::size_t wave = 0;
  std::string so_far;
  listener.progress = [&](const RunsProgress& progress) {
    line.show(so_far = fmt::format("wave {}: {}", wave, text_of(progress)));
  };
  const HindcastRuns done = run_hindcast(asked, options.runs.out, options.runs.fields(), executor,
                                         listener, [&](std::size_t begun) { wave = begun; });
  line.end_with(so_far);
  if (!done.summary) {
    fmt::print(stderr, "interrupted; the same command continues where this one was\n");
    return int(ExitCode::interrupted);
  }
  for (const std::string& failure : done.failures) fmt::print(stderr, "{}\n", failure);
  const Hindcast hindcast{asked, done.draws, done.rows, *done.summary};
  auto document = to_document(hindcast);
  document["date"] = db::utc_now();
  document["version"] = version();
  leave(hindcast, document, options.runs.out);
  if (options.runs.json) fmt::print("{}\n", document.dump(2));
  if (!options.runs.json) {
    fmt::print("{}{}\n", hindcast_table(hindcast), (options.runs.out / "hindcast.json").string());
  }
  const bool any = done.summary->posterior.effective > 0;
  return any ? int(ExitCode::result) : int(ExitCode::failure);
}

}  // namespace

void add_hindcast(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("hindcast", "What past slides teach about shared inputs");
  command->add_option("hindcast", options->file, "HINDCAST.json")
      ->required()
      ->check(CLI::ExistingFile);
  add_folder_runs_options(*command, options->runs, "hindcast", "runs and core-hours");
  command->footer(footer);
  command->callback([options, &exit_code] { exit_code = guarded([&] { return run(*options); }); });
}

}  // namespace leda::server
