#include "server/jobs/hindcast_folder.hpp"

#include <utility>

namespace leda::server {
namespace {

/// Runs whose case is sound. Those of the first wave all are; in later ones a draw between sound
/// ones may not be: it is told, and has no result.
struct SoundRuns {
  std::vector<solver::HindcastRun> runs;
  std::vector<CaseRun> cases;
};

SoundRuns sound_of(const HindcastFile& file, HindcastRuns& out,
                   const std::vector<solver::HindcastRun>& wanted) {
  SoundRuns sound;
  for (const auto& run : wanted) {
    CaseRun one{run_name(file.plan.draws, run), file.case_of(out.draws, run)};
    const auto read = read_case_file(one.of);
    if (read) {
      sound.runs.push_back(run);
      sound.cases.push_back(std::move(one));
      continue;
    }
    const Fault& fault = read.faults.front();
    out.failures.push_back(one.name + ": " + fault.pointer + " " + fault.message);
    out.rows.push_back(row_of(file, out.draws, run, std::nullopt));
  }
  return sound;
}

/// One draw of the local inputs, of members that have not slid before.
/// @return whether it was interrupted
bool run_draw(const HindcastFile& file, HindcastRuns& out,
              const std::vector<solver::HindcastRun>& runs, const std::filesystem::path& folder,
              Fields fields, Executor& executor, const RunsListener& listener) {
  const SoundRuns sound = sound_of(file, out, still_wanted(runs, out.rows));
  auto ended = run_cases(sound.cases, folder / "members", fields, executor, listener);
  if (ended.interrupted) return true;
  for (std::size_t i = 0; i < sound.runs.size(); ++i) {
    CaseRunEnd& end = ended.runs[i];
    if (!end.result) out.failures.push_back(sound.cases[i].name + ": " + end.reason);
    out.rows.push_back(row_of(file, out.draws, sound.runs[i], std::move(end.result)));
  }
  return false;
}

}  // namespace

HindcastRuns run_hindcast(const HindcastFile& file, const std::filesystem::path& folder,
                          Fields fields, Executor& executor, const RunsListener& listener,
                          const std::function<void(std::size_t)>& before_wave) {
  HindcastRuns out{solver::SharedDraws(file.plan.draws), {}, {}, {}};
  for (std::size_t wave = 0;; ++wave) {
    if (before_wave) before_wave(wave + 1);
    for (std::size_t local = 0; local < file.plan.draws.locals; ++local) {
      const auto runs = runs_of_draw(file.plan, wave, local);
      if (run_draw(file, out, runs, folder, fields, executor, listener)) return out;
    }
    const auto outcomes = outcomes_of(file, out.draws, out.rows);
    const auto weights = next_wave(file.plan, out.draws, outcomes);
    if (!weights) {
      out.summary = solver::summarize(file.plan, out.draws, outcomes);
      return out;
    }
    out.draws.add_wave(*weights);
  }
}

}  // namespace leda::server
