// leda ensemble: how sure, of one section.

#include <fmt/format.h>

#include "db/utc_now.hpp"
#include "disk/whole_file.hpp"
#include "server/commands/commands.hpp"
#include "server/commands/exit_code.hpp"
#include "server/commands/folder_runs.hpp"
#include "server/commands/progress_line.hpp"
#include "server/documents/ensemble_case.hpp"
#include "server/documents/member_warnings.hpp"
#include "server/documents/warning_lines.hpp"
#include "server/drawings/ensemble_drawing.hpp"
#include "server/jobs/ensemble_folder.hpp"
#include "server/jobs/executors/local_executor.hpp"
#include "server/jobs/run_size.hpp"
#include "server/operate/data_folder.hpp"
#include "server/operate/problem.hpp"
#include "server/operate/version.hpp"
#include "server/run/interrupt_signals.hpp"
#include "server/run/run_folder.hpp"
#include "solver/section/warnings.hpp"

namespace leda::server {
namespace {

namespace fs = std::filesystem;

constexpr const char* footer = R"(
CASE.json is a case file with an "ensemble":
  "ensemble": {"inputs": [
    {"name": "su", "path": "/materials/*/peak_strength_kPa", "apply": "scale",
     "distribution": {"type": "lognormal", "mean": 1, "cov": 0.15}},
    {"name": "water", "path": "/water_table/depth_m",
     "distribution": {"type": "triangular", "min": 0, "mode": 1, "max": 4}}],
   "stop": {"min_members": 64, "max_members": 512, "half_width": 0.05}}
A path is a JSON pointer into the case; * stands for every member. Leaves ensemble.json,
members.csv and ensemble.svg in DIR, and the case and result of each member in DIR/members; any of
them run again by leda simulate gives the same result. An ensemble that was interrupted or killed
goes on where it was.
Exit codes: 0 the ensemble stands, 1 no member gave a result, 2 it is invalid, 4 interrupted.)";

struct Options {
  fs::path file;
  FolderRunsOptions runs;
};

EnsembleCase read_ensemble(const fs::path& file) {
  auto parsed = parse_ensemble_case(read_whole(file));
  if (!parsed) {
    throw Problem(Failure::invalid_request, "the ensemble cannot be understood", parsed.faults);
  }
  return std::move(*parsed.value);
}

/// What so many members and their check cost, core-seconds. A finer cell costs the cube of how much
/// finer it is: more particles both ways, and shorter steps.
RunCost cost_of(const EnsembleCase& ensemble, std::size_t members) {
  const auto& plan = ensemble.asked.plan;
  const RunCost one = cost_of(run_size(ensemble.of.section, ensemble.of.settings),
                              typical_or_default(std::nullopt));
  RunCost all;
  for (const MemberRun& run : member_runs(plan, 0, members)) {
    const double finer =
        run.finer ? ensemble.of.settings.resolution.cell_m / *plan.check->cell_m : 1;
    all.likely_core_s += one.likely_core_s * finer * finer * finer;
    all.longest_core_s += one.longest_core_s * finer * finer * finer;
  }
  return all;
}

void show_dry_run(const EnsembleCase& ensemble, const std::vector<std::string>& warnings,
                  bool as_json) {
  const auto& plan = ensemble.asked.plan;
  const auto [least, most] = std::pair(plan.stop.min_members, plan.stop.max_members);
  const std::size_t least_runs = member_runs(plan, 0, least).size();
  const std::size_t most_runs = member_runs(plan, 0, most).size();
  const nlohmann::json estimate{
      {"members_at_least", least},
      {"members_at_most", most},
      {"runs_at_least", least_runs},
      {"runs_at_most", most_runs},
      {"core_hours_at_least", cost_of(ensemble, least).likely_core_s / 3600},
      {"core_hours_at_most", cost_of(ensemble, most).likely_core_s / 3600},
      {"core_hours_if_none_comes_to_rest", cost_of(ensemble, most).longest_core_s / 3600}};
  if (as_json) {
    fmt::print(
        "{}\n",
        nlohmann::json{{"dryRun", true}, {"warnings", warnings}, {"estimate", estimate}}.dump(2));
    return;
  }
  fmt::print("{} to {} members, {} to {} runs, {:.2g} to {:.2g} core-hours\n", least, most,
             least_runs, most_runs, estimate["core_hours_at_least"].get<double>(),
             estimate["core_hours_at_most"].get<double>());
}

void leave(const SectionEnsemble& ensemble, const EnsembleRuns& runs, const fs::path& out) {
  std::string csv = members_csv_head(ensemble.asked.plan.inputs);
  for (const MemberRow& row : runs.rows) csv += members_csv_line(row);
  disk::write_whole(out / "members.csv", csv);
  disk::write_whole(out / "ensemble.svg", ensemble_svg({ensemble}));
  auto document = to_document(ensemble);
  document["date"] = db::utc_now();
  document["version"] = version();
  disk::write_whole(out / "ensemble.json", document.dump(2) + "\n");
}

int run(const Options& options) {
  const EnsembleCase asked = read_ensemble(options.file);
  auto warnings = warnings_of(asked.of.section, asked.of.settings);
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
  std::string so_far;
  listener.progress = [&](const RunsProgress& progress) { line.show(so_far = text_of(progress)); };
  const EnsembleRuns done =
      run_ensemble(asked, options.runs.out, options.runs.fields(), executor, listener);
  line.end_with(so_far);
  if (!done.summary) {
    fmt::print(stderr, "interrupted; the same command continues where this one was\n");
    return int(ExitCode::interrupted);
  }
  for (const std::string& failure : done.failures) fmt::print(stderr, "{}\n", failure);
  auto of_members = member_lines(done.rows, done.summary->members, warnings);
  const SectionEnsemble ensemble{asked.of.section.name, asked.asked, *done.summary,
                                 std::move(warnings), std::move(of_members)};
  leave(ensemble, done, options.runs.out);
  if (options.runs.json) fmt::print("{}\n", to_document(ensemble).dump(2));
  if (!options.runs.json) {
    fmt::print("{}{}\n", ensemble_table(ensemble), (options.runs.out / "ensemble.json").string());
  }
  const bool any = done.failures.size() < done.rows.size();
  return any ? int(ExitCode::result) : int(ExitCode::failure);
}

}  // namespace

void add_ensemble(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("ensemble", "How sure: one section over its uncertain numbers");
  command->add_option("case", options->file, "CASE.json with an \"ensemble\"")
      ->required()
      ->check(CLI::ExistingFile);
  add_folder_runs_options(*command, options->runs, "ensemble", "members, runs and core-hours");
  command->footer(footer);
  command->callback([options, &exit_code] { exit_code = guarded([&] { return run(*options); }); });
}

}  // namespace leda::server
