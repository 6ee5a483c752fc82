#include "server/jobs/case_runs.hpp"

#include <fmt/format.h>

#include <chrono>
#include <map>
#include <thread>

#include "disk/whole_file.hpp"
#include "server/operate/version.hpp"
#include "server/run/run_checkpoint.hpp"
#include "server/run/run_folder.hpp"

namespace leda::server {
namespace {

namespace fs = std::filesystem;

/// Short beside a run of a second: a core that waits to be noticed is lost.
constexpr std::chrono::milliseconds between_looks{5};

std::string sha256_of(const CaseRun& run) {
  return case_sha256(read_case_file(run.of).value.value());
}

class Running {
 public:
  Running(const std::vector<CaseRun>& runs, const fs::path& folder, Fields fields,
          Executor& executor)
      : runs_(runs), folder_(folder), fields_(fields), executor_(executor) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      out_.runs.push_back({standing(i), ""});
      if (!out_.runs.back().result) waiting_.push_back(i);
    }
  }

  CaseRunEnds to_the_end(const RunsListener& listener) {
    tell(listener);
    while (next_ < waiting_.size() || !under_way_.empty()) {
      if (!out_.interrupted && listener.interrupted && listener.interrupted()) interrupt();
      const auto ends = executor_.poll();
      for (const RunEnd& end : ends) settle(end);
      const bool starts = next_ < waiting_.size() && executor_.free_slots() > 0;
      while (next_ < waiting_.size() && executor_.free_slots() > 0) start(waiting_[next_++]);
      if (starts || !ends.empty()) tell(listener);
      std::this_thread::sleep_for(between_looks);
    }
    return std::move(out_);
  }

 private:
  fs::path folder_of(std::size_t index) const { return folder_ / runs_[index].name; }

  /// The result in a run's folder, where it is of this case and this version.
  std::optional<SectionResult> standing(std::size_t index) const {
    const auto outcome = read_outcome(folder_of(index), fields_);
    if (!outcome.result || outcome.result->version != version()) return std::nullopt;
    if (outcome.result->case_sha256 != sha256_of(runs_[index])) return std::nullopt;
    return outcome.result;
  }

  void tell(const RunsListener& listener) const {
    if (!listener.progress) return;
    const std::size_t found = runs_.size() - waiting_.size();
    const std::size_t done = found + next_ - under_way_.size();
    listener.progress({runs_.size(), done, under_way_.size(), found});
  }

  void start(std::size_t index) {
    const fs::path folder = folder_of(index);
    fs::create_directories(folder);
    // An old result must not be taken for one of the new case.
    fs::remove(folder / "result.json");
    disk::write_whole(folder / "case.json", runs_[index].of.dump(2) + "\n");
    under_way_[runs_[index].name] = index;
    executor_.submit({runs_[index].name, folder});
  }

  void settle(const RunEnd& end) {
    const auto found = under_way_.find(end.run);
    if (found == under_way_.end()) return;
    CaseRunEnd& run = out_.runs[found->second];
    const fs::path folder = folder_of(found->second);
    run.result = standing(found->second);
    if (!run.result) {
      run.reason = end.reason.empty() ? read_outcome(folder).fault : end.reason;
      if (const auto words = last_words(folder); !words.empty()) run.reason += ": " + words;
    } else {
      remove_checkpoint(folder);
      if (fields_ == Fields::removed) fs::remove(folder / "fields.h5");
    }
    under_way_.erase(found);
  }

  void interrupt() {
    out_.interrupted = true;
    for (; next_ < waiting_.size(); ++next_) out_.runs[waiting_[next_]].reason = "interrupted";
    for (const auto& [name, index] : under_way_) executor_.cancel(name);
  }

  const std::vector<CaseRun>& runs_;
  fs::path folder_;
  Fields fields_;
  Executor& executor_;
  CaseRunEnds out_;
  std::vector<std::size_t> waiting_;  ///< indices of runs, in order
  std::size_t next_ = 0;              ///< of waiting_
  std::map<std::string, std::size_t> under_way_;
};

}  // namespace

std::string text_of(const RunsProgress& p) {
  return fmt::format("{} of {} runs done ({} found), {} running", p.done, p.runs, p.found,
                     p.running);
}

CaseRunEnds run_cases(const std::vector<CaseRun>& runs, const fs::path& folder, Fields fields,
                      Executor& executor, const RunsListener& listener) {
  return Running(runs, folder, fields, executor).to_the_end(listener);
}

}  // namespace leda::server
