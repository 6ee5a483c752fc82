#include "server/jobs/study_folder.hpp"

#include <utility>

#include "server/documents/study_setting.hpp"

namespace leda::server {

StudyRuns run_study(const StudyFile& study, const std::filesystem::path& folder, Executor& executor,
                    const RunsListener& listener) {
  StudyRuns out;
  std::vector<CaseRun> wanted;
  for (solver::StudyRun& run : solver::study_runs(study.question.settings)) {
    wanted.push_back({run_name(study.of, run), to_document(case_of(study.of, run))});
    out.runs.push_back(std::move(run));
  }
  auto ended = run_cases(wanted, folder / "runs", Fields::kept, executor, listener);
  out.interrupted = ended.interrupted;
  for (std::size_t i = 0; i < out.runs.size(); ++i) {
    out.runs[i].result = std::move(ended.runs[i].result);
    out.runs[i].reason = std::move(ended.runs[i].reason);
  }
  return out;
}

}  // namespace leda::server
