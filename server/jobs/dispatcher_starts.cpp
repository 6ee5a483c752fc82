// Which section runs next, and the folder that its worker starts from.

#include <algorithm>
#include <filesystem>

#include "disk/whole_file.hpp"
#include "server/jobs/dispatcher.hpp"
#include "server/operate/logging.hpp"
#include "server/operate/problem.hpp"
#include "server/run/run_checkpoint.hpp"

namespace leda::server {

using db::SectionState;

namespace {

constexpr int most_starts_a_turn = 50;
constexpr std::chrono::milliseconds shortest_pause_for_space{1000};
constexpr std::chrono::milliseconds longest_pause_for_space{60'000};

/// A folder that no earlier try has used, not even one that died before it was stored.
std::string new_folder(const DataFolder& data, const std::string& job,
                       const db::SectionRecord& section) {
  for (int number = section.attempts + 1;; ++number) {
    std::string run = job + "-" + std::to_string(section.ordinal) + "-" + std::to_string(number);
    if (std::filesystem::create_directory(data.run(run))) return run;
  }
}

/// What a try that was cut off reached is not lost for the next one.
void hand_over(const DataFolder& data, const std::string& job, const std::string& from,
               const std::string& to) {
  try {
    hand_over_checkpoint(data.run(from), data.run(to));
  } catch (const std::exception& error) {
    if (disk::tells_of_full_disk(error)) throw;
    remove_checkpoint(data.run(to));
    log_warning(job, "no checkpoint is handed over run={} reason={}", to, in_quotes(error.what()));
  }
}

}  // namespace

/// A limit, because screening may finish thousands of sections without ever filling a slot, and
/// runs that ended wait meanwhile.
void Dispatcher::start_runs() {
  for (int i = 0; i < most_starts_a_turn && executor_->free_slots() > 0 &&
                  std::chrono::steady_clock::now() >= no_start_before_;
       ++i) {
    let_go_dismissed_jobs();
    if (!start_next()) break;
  }
  running_ = runs_.size();
}

/// The job with the fewest runs comes first, so that a small one need not wait for a large one.
bool Dispatcher::start_next() {
  OpenJob* next = nullptr;
  for (auto& [id, job] : jobs_) {
    const auto waiting = job.sections.first_waiting();
    if (!waiting || job.sections.any_running(job.work->begins_after(*waiting))) continue;
    const bool sooner = next == nullptr || job.running < next->running ||
                        (job.running == next->running && job.record.created < next->record.created);
    if (sooner) next = &job;
  }
  if (next == nullptr) return false;
  const std::size_t index = next->sections.first_waiting().value();
  auto section = store_.section(next->sections.id(index)).value();
  if (!screened_out(*next, index, section)) start_run(*next, index, section);
  return true;
}

/// True where a section needs no run: others say enough without it, or screening, where it was not
/// screened yet, finds it stable.
bool Dispatcher::screened_out(OpenJob& job, std::size_t index, db::SectionRecord& section) {
  if (const auto reason = job.work->not_needed(section); !reason.empty()) {
    set_state(job, index, SectionState::left_out, reason);
    return true;
  }
  if (!section.screening.empty()) return false;
  const auto screened = job.work->screen(section);
  if (!screened) return false;
  if (!section.member) store_.set_screening(section.id, screened->document);
  section.screening = screened->document;
  if (!screened->skip) return false;
  set_state(job, index, SectionState::stable, "not simulated: " + screened->reason);
  return true;
}

/// A folder with all that a worker needs, booked in the store; nothing where the job was dismissed
/// meanwhile.
std::optional<std::string> Dispatcher::new_run(const OpenJob& job,
                                               const db::SectionRecord& section) {
  std::string run = new_folder(data_, job.record.id, section);
  const auto remove_folder = [&] {
    std::error_code ignored;
    std::filesystem::remove_all(data_.run(run), ignored);
  };
  try {
    disk::write_durably(data_.run(run) / "case.json", job.work->case_file(section));
    if (!section.run.empty()) hand_over(data_, job.record.id, section.run, run);
    if (store_.start_run(section.id, run)) return run;
  } catch (...) {
    remove_folder();
    throw;
  }
  remove_folder();
  return std::nullopt;
}

void Dispatcher::start_run(OpenJob& job, std::size_t index, db::SectionRecord& section) {
  const std::string id = job.record.id, before = section.run;
  try {
    const auto run = new_run(job, section);
    if (!run) return job.sections.set_state(index, SectionState::dismissed);
    section.run = *run;
  } catch (const db::StoreError&) {
    throw;
  } catch (const std::exception& error) {
    if (disk::tells_of_full_disk(error)) return wait_for_space();
    log_error(id, "run cannot be started section={} reason={}", in_quotes(section.name),
              in_quotes(error.what()));
    set_state(job, index, SectionState::failed,
              data_.without_root(std::string("the run cannot be started: ") + error.what()));
    return;
  }
  if (!before.empty()) remove_checkpoint_of(before);
  job.sections.set_state(index, SectionState::running);
  runs_[section.run] = {id, index};
  ++job.running;
  executor_->submit({section.run, data_.run(section.run)});
  log_info(id, "run started section={} run={}", in_quotes(section.name), section.run);
}

/// Runs that found no space are no failures: they wait, and go on from their checkpoints.
void Dispatcher::wait_for_space() {
  pause_for_space_ =
      std::clamp(2 * pause_for_space_, shortest_pause_for_space, longest_pause_for_space);
  no_start_before_ = std::chrono::steady_clock::now() + pause_for_space_;
  log_error("-", "the disk is full: no run is started for {} s", pause_for_space_.count() / 1000);
}

}  // namespace leda::server
