#include "server/jobs/study_folder.hpp"

#include <chrono>
#include <map>
#include <thread>
#include <utility>

#include "server/documents/study_setting.hpp"
#include "server/jobs/take_in.hpp"
#include "server/operate/version.hpp"
#include "server/run/run_folder.hpp"

namespace leda::server {
namespace {

namespace fs = std::filesystem;
using solver::StudyRun;

constexpr std::chrono::milliseconds between_looks{50};

/// The result in a run's folder, where it is of this case and this version.
std::optional<SectionResult> standing(const fs::path& folder, const CaseFile& run) {
  const auto outcome = read_outcome(folder);
  if (!outcome.result || outcome.result->case_sha256 != case_sha256(run)) return std::nullopt;
  if (outcome.result->version != version()) return std::nullopt;
  return outcome.result;
}

class Running {
 public:
  Running(const StudyFile& study, fs::path folder, Executor& executor)
      : study_(study), folder_(std::move(folder)), executor_(executor) {
    for (StudyRun& run : solver::study_runs(study.question.settings)) {
      run.result = standing(folder_of(run), case_of(study.of, run));
      if (!run.result) waiting_.push_back(out_.runs.size());
      out_.runs.push_back(std::move(run));
    }
  }

  StudyRuns to_the_end(const StudyListener& listener) {
    while (next_ < waiting_.size() || !under_way_.empty()) {
      if (!out_.interrupted && listener.interrupted && listener.interrupted()) interrupt();
      while (next_ < waiting_.size() && executor_.free_slots() > 0) start(waiting_[next_++]);
      for (const RunEnd& end : executor_.poll()) settle(end);
      if (listener.progress) listener.progress(progress());
      std::this_thread::sleep_for(between_looks);
    }
    return std::move(out_);
  }

 private:
  fs::path folder_of(const StudyRun& run) const {
    return folder_ / "runs" / run_name(study_.of, run);
  }

  StudyProgress progress() const {
    const std::size_t found = out_.runs.size() - waiting_.size();
    const std::size_t done = found + next_ - under_way_.size();
    return {out_.runs.size(), done, under_way_.size(), found};
  }

  void start(std::size_t index) {
    const StudyRun& run = out_.runs[index];
    const fs::path folder = folder_of(run);
    fs::create_directories(folder);
    // An old result must not be taken for one of the new case.
    fs::remove(folder / "result.json");
    disk::write_whole(folder / "case.json", to_document(case_of(study_.of, run)).dump(2) + "\n");
    const std::string name = run_name(study_.of, run);
    under_way_[name] = index;
    executor_.submit({name, folder});
  }

  void settle(const RunEnd& end) {
    const auto found = under_way_.find(end.run);
    if (found == under_way_.end()) return;
    StudyRun& run = out_.runs[found->second];
    const fs::path folder = folder_of(run);
    run.result = standing(folder, case_of(study_.of, run));
    if (!run.result) {
      run.reason = end.reason.empty() ? read_outcome(folder).fault : end.reason;
      if (const auto words = last_words(folder); !words.empty()) run.reason += ": " + words;
    }
    under_way_.erase(found);
  }

  void interrupt() {
    out_.interrupted = true;
    for (; next_ < waiting_.size(); ++next_) out_.runs[waiting_[next_]].reason = "interrupted";
    for (const auto& [name, index] : under_way_) executor_.cancel(name);
  }

  const StudyFile& study_;
  fs::path folder_;
  Executor& executor_;
  StudyRuns out_;
  std::vector<std::size_t> waiting_;  ///< indices of runs, in order
  std::size_t next_ = 0;              ///< of waiting_
  std::map<std::string, std::size_t> under_way_;
};

}  // namespace

StudyRuns run_study(const StudyFile& study, const fs::path& folder, Executor& executor,
                    const StudyListener& listener) {
  return Running(study, folder, executor).to_the_end(listener);
}

}  // namespace leda::server
