// What becomes of a run that ended, and of a job whose runs all did.

#include <algorithm>

#include "server/jobs/dispatcher.hpp"
#include "server/layers/features.hpp"
#include "server/operate/logging.hpp"
#include "server/run/run_folder.hpp"

namespace leda::server {

using db::JobState;
using db::SectionState;

namespace {

constexpr std::chrono::milliseconds shortest_between_reports{500};
// Progress is read from a file a run. Where thousands go on a cluster, their folder is a network's.
constexpr std::chrono::milliseconds between_reports_for_each_run{10};

/// Where they stay, purge removes them with their folder.
void remove_fields(const std::filesystem::path& run) {
  std::error_code ignored;
  std::filesystem::remove(run / "fields.h5", ignored);
}

}  // namespace

/// Runs that ended while nobody watched are taken in, those that still go are adopted, and those
/// that were cut off start anew.
void Dispatcher::recover(OpenJob& job) {
  const std::string& id = job.record.id;
  int restarted = 0, adopted = 0;
  for (std::size_t index = 0; index < job.sections.size(); ++index) {
    if (job.sections.state(index) != SectionState::running) continue;
    const std::string run = store_.section(job.sections.id(index)).value().run;
    if (const auto outcome = read_outcome(data_.run(run)); outcome.result) {
      take_in(job, index, run, outcome);
    } else if (executor_->adopt({run, data_.run(run)})) {
      runs_[run] = {id, index};
      ++job.running;
      ++adopted;
    } else {
      set_state(job, index, SectionState::waiting, "");
      ++restarted;
    }
  }
  if (adopted > 0) log_info(id, "runs go on runs={}", adopted);
  if (restarted > 0) log_info(id, "runs start anew runs={}", restarted);
  if (restarted > 0 && watch_.restarted) watch_.restarted(restarted);
}

/// An end stays here until it is settled: where the store fails it is tried again.
void Dispatcher::settle_ended_runs() {
  for (auto& end : executor_->poll()) ended_.push_back(std::move(end));
  while (!ended_.empty()) {
    let_go_dismissed_jobs();
    settle(ended_.front());
    ended_.pop_front();
  }
}

void Dispatcher::settle(const RunEnd& end) {
  const auto run = runs_.find(end.run);
  if (run == runs_.end()) return;  // of a job that was dismissed
  OpenJob& job = jobs_.at(run->second.job);
  const Outcome outcome = read_outcome(data_.run(end.run));
  const bool by_itself = end.how == RunEnd::How::exited;
  if (by_itself && (end.exit_code == 0 || end.exit_code == 3) && outcome.result) {
    take_in(job, run->second.section, end.run, outcome);
    pause_for_space_ = {};
  } else {
    gave_no_result(job, run->second.section, end, outcome);
  }
  --job.running;
  runs_.erase(run);
}

/// The section waits for another try, or has had the last one.
void Dispatcher::gave_no_result(OpenJob& job, std::size_t index, const RunEnd& end,
                                const Outcome& outcome) {
  const auto code = end.how == RunEnd::How::exited ? ExitCode(end.exit_code) : ExitCode::failure;
  std::string reason = end.reason.empty() ? outcome.fault : end.reason;
  if (code == ExitCode::out_of_memory) reason = "memory";
  if (code == ExitCode::disk_full) reason = "the disk is full";
  if (const auto words = last_words(data_.run(end.run)); !words.empty()) reason += ": " + words;
  reason = data_.without_root(reason);

  const bool hopeless = end.how == RunEnd::How::over_limit || code == ExitCode::invalid ||
                        code == ExitCode::out_of_memory;
  const int crashes = job.crashes[index] + (code == ExitCode::disk_full ? 0 : 1);
  const bool again = !hopeless && crashes < most_tries;
  log_warning(job.record.id, "run gave no result run={} again={} reason={}", end.run, again,
              in_quotes(reason));
  set_state(job, index, again ? SectionState::waiting : SectionState::failed, reason);
  // Only now, because a store that fails brings this end back for another turn.
  job.crashes[index] = crashes;
  if (again && watch_.restarted) watch_.restarted(1);
  if (code == ExitCode::disk_full) wait_for_space();
}

/// First the file is in place, then the row.
void Dispatcher::take_in(OpenJob& job, std::size_t index, const std::string& run,
                         const Outcome& outcome) {
  const auto section = store_.section(job.sections.id(index)).value();
  const SectionResult& result = outcome.result.value();
  PlacedResult placed;
  try {
    placed = job.work->place(section, result);
  } catch (const std::exception& error) {
    set_state(
        job, index, SectionState::failed,
        data_.without_root(std::string("the result has no place on the map: ") + error.what()));
    return;
  }
  store_.take_in(section.id, run, result, placed, outcome.document);
  remove_checkpoint_of(run);
  if (section.member) remove_fields(data_.run(run));
  const bool usable = result.status != RunStatus::unstable;
  job.sections.set_state(index, usable ? SectionState::finished : SectionState::failed);
  if (watch_.taken_in) watch_.taken_in(result);
  log_info(job.record.id,
           "result section={} run={} status={} retrogression_m={:.1f} runout_m={:.1f} "
           "run_time_s={:.1f} case_sha256={}",
           in_quotes(section.name), run, to_string(result.status),
           result.crest_to_crest_retrogression_m, result.runout_m, result.run_time_s,
           result.case_sha256);
}

/// Nothing where it is too soon to tell again.
std::optional<Dispatcher::Fractions> Dispatcher::read_fractions() {
  const auto now = std::chrono::steady_clock::now();
  const auto between = std::max(shortest_between_reports,
                                between_reports_for_each_run * static_cast<int>(runs_.size()));
  if (now - progress_told_ < between) return std::nullopt;
  progress_told_ = now;
  Fractions fractions;
  for (const auto& [run, of] : runs_) fractions[of.job] += read_fraction(data_.run(run));
  return fractions;
}

void Dispatcher::report_progress() {
  const auto fractions = read_fractions();
  if (!fractions) return;
  for (auto& [id, job] : jobs_) {
    if (job.record.state != JobState::running) continue;
    const auto known = fractions->find(id);
    const int percent =
        progress_percent(job.sections.counts(), known == fractions->end() ? 0 : known->second);
    const std::string message = progress_message(job.sections.counts());
    if (percent == job.record.progress && message == job.record.message) continue;
    store_.set_job_progress(id, percent, message);
    job.record.progress = percent;
    job.record.message = message;
  }
}

void Dispatcher::finish_done_jobs() {
  std::vector<std::string> done;
  for (const auto& [id, job] : jobs_) {
    if (job.running == 0 && job.sections.counts().of(SectionState::waiting) == 0)
      done.push_back(id);
  }
  for (const auto& id : done) {
    let_go_dismissed_jobs();
    if (const auto job = jobs_.find(id); job != jobs_.end()) finish(job->second);
  }
}

void Dispatcher::finish(const OpenJob& job) {
  const std::string id = job.record.id;
  std::vector<Zone> zones;
  std::string fault;
  try {
    zones = job.work->zones(store_.sections(id));
  } catch (const db::StoreError&) {
    throw;
  } catch (const std::exception& error) {
    fault = std::string("the zones could not be made: ") + error.what();
  }
  const JobCounts& counts = job.sections.counts();
  const bool all_failed = counts.of(SectionState::failed) > 0 &&
                          counts.of(SectionState::finished) + counts.of(SectionState::stable) == 0;
  const JobState state = all_failed || !fault.empty() ? JobState::failed : JobState::successful;
  const std::string message = fault.empty() ? final_message(counts) : fault;
  if (fault.empty()) {
    store_.set_zones(id, zones);
    keep_zone_boxes(store_, job.record);
  }
  if (state == JobState::successful) store_.set_job_progress(id, 100, message);
  store_.set_job_state(id, state, message);
  jobs_.erase(id);
  log_info(id, "finished status={} message={}", db::to_string(state), in_quotes(message));
}

void Dispatcher::set_state(OpenJob& job, std::size_t index, SectionState state,
                           const std::string& reason) {
  store_.set_section_state(job.sections.id(index), state, reason);
  job.sections.set_state(index, state);
}

}  // namespace leda::server
