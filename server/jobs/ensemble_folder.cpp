#include "server/jobs/ensemble_folder.hpp"

#include <utility>

namespace leda::server {

EnsembleRuns run_ensemble(const EnsembleCase& ensemble, const std::filesystem::path& folder,
                          Fields fields, Executor& executor, const RunsListener& listener) {
  const auto& plan = ensemble.asked.plan;
  EnsembleRuns out;
  std::size_t from = 0;
  for (std::size_t members = plan.stop.min_members;; members *= 2) {
    const auto runs = member_runs(plan, from, members);
    std::vector<CaseRun> wanted;
    for (const MemberRun& run : runs) wanted.push_back({run_name(run), ensemble.case_of(run)});
    auto ended = run_cases(wanted, folder / "members", fields, executor, listener);
    if (ended.interrupted) return out;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      CaseRunEnd& end = ended.runs[i];
      if (!end.result) out.failures.push_back(wanted[i].name + ": " + end.reason);
      out.rows.push_back(row_of(ensemble, ensemble.place(), runs[i], std::move(end.result)));
    }
    from = members;
    auto summary = solver::summarize(plan, members_of(out.rows));
    if (summary.ending == solver::Ending::more_members) continue;
    weigh(out.rows, members);
    out.summary = std::move(summary);
    return out;
  }
}

}  // namespace leda::server
