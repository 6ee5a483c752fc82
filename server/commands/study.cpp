// leda study: one section over cell sizes, particles, time steps and seeds; error against run time.

#include <fmt/format.h>

#include <algorithm>

#include "db/store.hpp"
#include "server/commands/commands.hpp"
#include "server/commands/exit_code.hpp"
#include "server/commands/folder_option.hpp"
#include "server/commands/folder_runs.hpp"
#include "server/commands/progress_line.hpp"
#include "server/documents/study_document.hpp"
#include "server/documents/warning_lines.hpp"
#include "server/drawings/study_drawing.hpp"
#include "server/jobs/executors/local_executor.hpp"
#include "server/jobs/study_folder.hpp"
#include "server/operate/data_folder.hpp"
#include "server/operate/problem.hpp"
#include "server/run/interrupt_signals.hpp"
#include "server/run/run_folder.hpp"

namespace leda::server {
namespace {

namespace fs = std::filesystem;

constexpr const char* footer = R"(
STUDY.json:
  {"name": "bank", "case_file": "bank.json", "cell_m": [0.75, 1, 1.5],
   "particles_per_cell": [4, 9], "time_step_factor": [0.65, 0.9], "seeds": 3,
   "reference": {"retrogression_m": 100, "runout_m": 52, "source": "field survey"},
   "wanted_error": 0.1, "workers": 2}
time_step_factor (of h / c_p) may be left out: the case's own. case_file is relative to STUDY.json;
"case" with a case in its place works too. "reference" may be "finest". Leaves study.json, study.csv
and study.svg in DIR, and every run under DIR/runs. A study that was interrupted goes on where it
was: runs that stand in DIR are not run again.
Run times are wall times: let nothing else run on the machine, and no more workers than cores.
Exit codes: 0 the study stands, 1 no run gave a result, 2 the study is invalid, 4 interrupted.)";

struct Options {
  fs::path study;
  fs::path out;
  std::optional<int> workers;
  bool json = false;
};

StudyFile read_study(const fs::path& file) {
  auto parsed = parse_study_file(read_whole(file), cases_beside(file));
  if (!parsed) {
    throw Problem(Failure::invalid_request, "the study cannot be understood", parsed.faults);
  }
  return std::move(*parsed.value);
}

std::size_t workers_of(const Options& options, const StudyFile& study) {
  return workers_or_cores(std::size_t(options.workers.value_or(study.workers)));
}

void leave(const Study& study, const fs::path& out) {
  disk::write_whole(out / "study.csv", study_csv(study));
  disk::write_whole(out / "study.svg", study_svg(study));
  disk::write_whole(out / "study.json", to_document(study).dump(2) + "\n");
}

int run(const Options& options) {
  StudyFile asked = read_study(options.study);
  fmt::print(stderr, "{}",
             warning_lines(study_warnings(asked, solver::study_runs(asked.question.settings))));
  const InterruptSignals signals;
  ProgressLine line;
  fs::create_directories(options.out);
  LocalExecutor executor(program_beside(), workers_of(options, asked));
  RunsListener listener;
  listener.interrupted = InterruptSignals::arrived;
  std::string so_far;
  listener.progress = [&](const RunsProgress& progress) { line.show(so_far = text_of(progress)); };
  StudyRuns done = run_study(asked, options.out, executor, listener);
  line.end_with(so_far);
  if (done.interrupted) {
    fmt::print(stderr, "interrupted; the same command continues where this one was\n");
    return int(ExitCode::interrupted);
  }
  const Study study = conclude(std::move(asked), std::move(done.runs), db::utc_now());
  leave(study, options.out);
  if (options.json) fmt::print("{}\n", to_document(study).dump(2));
  if (!options.json) {
    fmt::print("{}{}\n", study_table(study), (options.out / "study.json").string());
  }
  const bool any = std::ranges::any_of(study.runs, solver::is_usable);
  return any ? int(ExitCode::result) : int(ExitCode::failure);
}

}  // namespace

void add_study(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("study", "Error against run time of one section over resolutions");
  command->add_option("study", options->study, "STUDY.json")->required()->check(CLI::ExistingFile);
  command->add_option("--out", options->out, "folder of the study; made where it is missing")
      ->required()
      ->check(no_folder);
  command
      ->add_option("--workers", options->workers,
                   "runs at the same time, in place of the study's; 0: one a core")
      ->check(CLI::Range(0, 1024));
  command->add_flag("--json", options->json, "print study.json");
  command->footer(footer);
  command->callback([options, &exit_code] { exit_code = guarded([&] { return run(*options); }); });
}

}  // namespace leda::server
