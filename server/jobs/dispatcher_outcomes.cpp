// What becomes of a run that ended, and of a job whose runs all did.

#include <algorithm>

#include "server/jobs/dispatcher.hpp"
#include "server/jobs/take_in.hpp"
#include "server/layers/features.hpp"
#include "server/layers/summary.hpp"
#include "server/operate/logging.hpp"
#include "server/run/run_folder.hpp"

namespace leda::server {

using db::JobState;
using db::SectionState;

namespace {

constexpr std::chrono::milliseconds shortest_between_reports{500};
// Progress is read from a file a run. Where thousands go on a cluster, their folder is a network's.
constexpr std::chrono::milliseconds between_reports_for_each_run{10};

}  // namespace

/// Runs that ended while nobody watched are taken in, those that still go are adopted, and those
/// that were cut off start anew.
void Dispatcher::recover(OpenJob& job) {
  const std::string& id = job.record.id;
  int restarted = 0, adopted = 0;
  for (std::size_t index = 0; index < job.sections.size(); ++index) {
    auto& section = job.sections[index];
    if (section.state != SectionState::running) continue;
    const auto folder = data_.run(section.run);
    if (read_outcome(folder).result) {
      take_in(job, section);
    } else if (executor_->adopt({section.run, folder})) {
      runs_[section.run] = {id, index};
      ++job.running;
      ++adopted;
    } else {
      set_state(job, section, SectionState::waiting, "");
      ++restarted;
    }
  }
  if (adopted > 0) log_info(id, "runs go on runs={}", adopted);
  if (restarted > 0) log_info(id, "runs start anew runs={}", restarted);
  if (restarted > 0 && watch_.restarted) watch_.restarted(restarted);
}

void Dispatcher::settle(const RunEnd& end) {
  const auto run = runs_.find(end.run);
  if (run == runs_.end()) return;  // of a job that was dismissed
  OpenJob& job = jobs_.at(run->second.job);
  const std::size_t index = run->second.section;
  const bool by_itself = end.how == RunEnd::How::exited;
  const Outcome outcome = read_outcome(data_.run(end.run));
  if (by_itself && (end.exit_code == 0 || end.exit_code == 3) && outcome.result) {
    take_in(job, job.sections[index]);
    pause_for_space_ = {};
  } else {
    gave_no_result(job, index, end, outcome.fault);
  }
  --job.running;
  runs_.erase(end.run);
}

/// The section waits for another try, or has had the last one.
void Dispatcher::gave_no_result(OpenJob& job, std::size_t index, const RunEnd& end,
                                const std::string& fault) {
  db::SectionRecord& section = job.sections[index];
  const auto code = end.how == RunEnd::How::exited ? ExitCode(end.exit_code) : ExitCode::failure;
  std::string reason = end.reason.empty() ? fault : end.reason;
  if (code == ExitCode::out_of_memory) reason = "memory";
  if (code == ExitCode::disk_full) reason = "the disk is full";
  if (const auto words = last_words(data_.run(end.run)); !words.empty()) reason += ": " + words;
  reason = data_.without_root(reason);

  const bool hopeless = end.how == RunEnd::How::over_limit || code == ExitCode::invalid ||
                        code == ExitCode::out_of_memory;
  const int crashes = job.crashes[index] + (code == ExitCode::disk_full ? 0 : 1);
  const bool again = !hopeless && crashes < most_tries;
  log_warning(job.record.id, "run gave no result section={} run={} again={} reason={}",
              in_quotes(section.name), end.run, again, in_quotes(reason));
  set_state(job, section, again ? SectionState::waiting : SectionState::failed, reason);
  // Only now, because a store that fails brings this end back for another turn.
  job.crashes[index] = crashes;
  if (again && watch_.restarted) watch_.restarted(1);
  if (code == ExitCode::disk_full) wait_for_space();
}

/// First the file is in place, then the row.
void Dispatcher::take_in(OpenJob& job, db::SectionRecord& section) {
  const Outcome outcome = read_outcome(data_.run(section.run));
  const SectionResult& result = outcome.result.value();
  PlacedResult placed;
  try {
    placed = job.work->place(section, result);
  } catch (const std::exception& error) {
    set_state(
        job, section, SectionState::failed,
        data_.without_root(std::string("the result has no place on the map: ") + error.what()));
    return;
  }
  store_.take_in(section.id, section.run, result, placed, outcome.document);
  remove_checkpoint_of(section.run);
  const bool usable = result.status != RunStatus::unstable;
  section.state = usable ? SectionState::finished : SectionState::failed;
  section.reason = result.reason;
  section.result = result;
  section.placed = placed;
  if (watch_.taken_in) watch_.taken_in(result);
  log_info(job.record.id,
           "result section={} run={} status={} retrogression_m={:.1f} runout_m={:.1f} "
           "run_time_s={:.1f} case_sha256={}",
           in_quotes(section.name), section.run, to_string(result.status),
           result.crest_to_crest_retrogression_m, result.runout_m, result.run_time_s,
           result.case_sha256);
}

void Dispatcher::report_progress() {
  const auto now = std::chrono::steady_clock::now();
  const auto between = std::max(shortest_between_reports,
                                between_reports_for_each_run * static_cast<int>(runs_.size()));
  if (now - progress_told_ < between) return;
  progress_told_ = now;
  std::map<std::string, double> fractions;
  for (const auto& [run, of] : runs_) fractions[of.job] += read_fraction(data_.run(run));
  for (auto& [id, job] : jobs_) {
    if (job.record.state != JobState::running) continue;
    const int percent = progress_percent(job.sections, fractions[id]);
    const std::string message = progress_message(job.sections);
    if (percent == job.record.progress && message == job.record.message) continue;
    store_.set_job_progress(id, percent, message);
    job.record.progress = percent;
    job.record.message = message;
  }
}

void Dispatcher::finish_done_jobs() {
  for (auto at = jobs_.begin(); at != jobs_.end();) {
    const bool done = at->second.running == 0 && at->second.waiting.empty();
    if (done) finish(at->second);
    at = done ? jobs_.erase(at) : std::next(at);
  }
}

void Dispatcher::finish(OpenJob& job) {
  const std::string& id = job.record.id;
  JobState state = JobState::successful;
  std::string message = final_message(job.sections);
  if (count(job.sections, SectionState::failed) > 0 &&
      count(job.sections, SectionState::finished) + count(job.sections, SectionState::stable) ==
          0) {
    state = JobState::failed;
  }
  try {
    store_.set_zones(id, job.work->zones(job.sections));
    keep_boxes(store_, job.record);
  } catch (const db::StoreError&) {
    throw;
  } catch (const std::exception& error) {
    state = JobState::failed;
    message = std::string("the zones could not be made: ") + error.what();
  }
  if (state == JobState::successful) store_.set_job_progress(id, 100, message);
  store_.set_job_state(id, state, message);
  log_info(id, "finished status={} message={}", db::to_string(state), in_quotes(message));
}

void Dispatcher::set_state(OpenJob& job, db::SectionRecord& section, SectionState state,
                           const std::string& reason) {
  store_.set_section_state(section.id, state, reason);
  section.state = state;
  section.reason = reason;
  const auto index = static_cast<std::size_t>(&section - job.sections.data());
  if (state == SectionState::waiting) {
    job.waiting.insert(index);
  } else {
    job.waiting.erase(index);
  }
}

}  // namespace leda::server
