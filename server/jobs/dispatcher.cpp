#include "server/jobs/dispatcher.hpp"

#include <algorithm>
#include <filesystem>

#include "disk/whole_file.hpp"
#include "server/operate/logging.hpp"
#include "server/operate/problem.hpp"
#include "server/run/run_checkpoint.hpp"

namespace leda::server {

using db::JobState;
using db::SectionState;

namespace {

constexpr int most_starts_a_turn = 50;
constexpr std::chrono::milliseconds between_turns{50};
constexpr std::chrono::milliseconds after_failure{1000};
constexpr std::chrono::milliseconds to_wind_down{3500};
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

Dispatcher::Dispatcher(const DataFolder& data, db::Store& store, MakeExecutor make_executor,
                       RunWatch watch)
    : data_(data),
      store_(store),
      make_executor_(std::move(make_executor)),
      watch_(std::move(watch)),
      last_turn_(std::chrono::steady_clock::now()) {}

Dispatcher::~Dispatcher() {
  {
    const std::lock_guard lock(inbox_mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void Dispatcher::start() {
  const std::lock_guard lock(inbox_mutex_);
  for (const auto& job : store_.unfinished_jobs()) to_take_up_.push_back(job.id);
  thread_ = std::thread([this] { work(); });
}

void Dispatcher::add(const std::string& job) {
  {
    const std::lock_guard lock(inbox_mutex_);
    to_take_up_.push_back(job);
  }
  wake_.notify_all();
}

std::size_t Dispatcher::running() const { return running_; }

std::chrono::steady_clock::duration Dispatcher::since_last_turn() const {
  return std::chrono::steady_clock::now() - last_turn_.load();
}

void Dispatcher::dismiss(const std::string& job) {
  {
    const std::lock_guard inbox(inbox_mutex_);
    std::erase(to_take_up_, job);
  }
  const std::lock_guard lock(mutex_);
  store_.dismiss_job(job);
  const auto found = jobs_.find(job);
  if (found != jobs_.end()) {
    for (const auto& [run, of] : runs_) {
      if (of.job == job) executor_->cancel(run);
    }
    std::erase_if(runs_, [&](const auto& entry) { return entry.second.job == job; });
    jobs_.erase(found);
    running_ = runs_.size();
  }
  log_info(job, "dismissed");
}

void Dispatcher::work() {
  for (bool stopped = false; !stopped;) {
    auto pause = between_turns;
    try {
      turn();
      last_turn_ = std::chrono::steady_clock::now();
    } catch (const std::exception& error) {
      log_error("-", "dispatcher tries again reason={}", in_quotes(error.what()));
      pause = after_failure;
    }
    std::unique_lock inbox(inbox_mutex_);
    wake_.wait_for(inbox, pause, [this] { return stop_ || !to_take_up_.empty(); });
    stopped = stop_;
  }
  const std::lock_guard lock(mutex_);
  if (executor_) wind_down();
  executor_.reset();
}

void Dispatcher::turn() {
  {
    const std::lock_guard lock(mutex_);
    if (!executor_) executor_ = make_executor_();
  }
  take_up_new_jobs();
  settle_ended_runs();
  const auto fractions = read_fractions();
  {
    const std::lock_guard lock(mutex_);
    // A limit, because screening may finish thousands of sections without ever filling a slot, and
    // the jobs of others wait for the lock meanwhile.
    for (int i = 0; i < most_starts_a_turn && executor_->free_slots() > 0 &&
                    std::chrono::steady_clock::now() >= no_start_before_ && start_next();
         ++i) {
    }
    running_ = runs_.size();
    book_started_jobs();
    if (fractions) report_progress(*fractions);
  }
  finish_done_jobs();
}

/// A job leaves the inbox when it was taken up: where the store fails it is tried again.
void Dispatcher::take_up_new_jobs() {
  for (;;) {
    std::string id;
    {
      const std::lock_guard inbox(inbox_mutex_);
      if (to_take_up_.empty()) return;
      id = to_take_up_.front();
    }
    take_up(id);
    const std::lock_guard inbox(inbox_mutex_);
    if (!to_take_up_.empty() && to_take_up_.front() == id) to_take_up_.pop_front();
  }
}

void Dispatcher::take_up(const std::string& id) {
  auto job = open(id);
  if (!job) return;
  const auto left = left_running(*job);
  const std::lock_guard lock(mutex_);
  const auto now = store_.job(id);
  if (!now || now->state == JobState::dismissed) return;
  recover(*job, left);
  log_info(id, "taken up sections={} waiting={}", job->sections.size(),
           job->sections.counts().of(SectionState::waiting));
  jobs_[id] = std::move(*job);
}

/// Nothing where the job is finished or known already, or cannot be understood.
std::optional<Dispatcher::OpenJob> Dispatcher::open(const std::string& id) {
  auto record = store_.job(id);
  if (!record || db::is_final(record->state)) return std::nullopt;
  {
    const std::lock_guard lock(mutex_);
    if (jobs_.contains(id)) return std::nullopt;
  }
  OpenJob job;
  try {
    const Process* process = find_process(record->process);
    if (process == nullptr) throw std::runtime_error("no process " + record->process);
    job.work = process->open(record->request, {data_, store_, record->raster});
    job.sections = SectionQueue(store_.sections_in_line(id));
    if (job.sections.size() == 0) {
      store_.set_sections(id, job.work->plan());
      job.sections = SectionQueue(store_.sections_in_line(id));
    }
    job.work->planned();
  } catch (const db::StoreError&) {
    throw;
  } catch (const std::exception& error) {
    log_error(id, "cannot be taken up reason={}", in_quotes(error.what()));
    store_.set_job_state(id, JobState::failed,
                         std::string("the job could not be taken up: ") + error.what());
    return std::nullopt;
  }
  record->request = {};
  job.record = std::move(*record);
  return job;
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

/// A folder with all that a worker needs, booked in the store.
std::string Dispatcher::new_run(const OpenJob& job, const db::SectionRecord& section) {
  std::string run = new_folder(data_, job.record.id, section);
  try {
    disk::write_durably(data_.run(run) / "case.json", job.work->case_file(section));
    if (!section.run.empty()) hand_over(data_, job.record.id, section.run, run);
    store_.start_run(section.id, run);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove_all(data_.run(run), ignored);
    throw;
  }
  return run;
}

void Dispatcher::start_run(OpenJob& job, std::size_t index, db::SectionRecord& section) {
  const std::string id = job.record.id, before = section.run;
  try {
    section.run = new_run(job, section);
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

void Dispatcher::book_started_jobs() {
  for (auto& [id, job] : jobs_) {
    if (job.record.state != JobState::accepted || job.running == 0) continue;
    store_.set_job_state(id, JobState::running, progress_message(job.sections.counts()));
    job.record.state = JobState::running;
  }
}

/// A checkpoint that is of no more use; where it stays, purge removes it with its folder.
void Dispatcher::remove_checkpoint_of(const std::string& run) {
  try {
    remove_checkpoint(data_.run(run));
  } catch (const std::filesystem::filesystem_error& error) {
    log_warning("-", "checkpoint stays run={} reason={}", run, in_quotes(error.what()));
  }
}

/// Runs that found no space are no failures: they wait, and go on from their checkpoints.
void Dispatcher::wait_for_space() {
  pause_for_space_ =
      std::clamp(2 * pause_for_space_, shortest_pause_for_space, longest_pause_for_space);
  no_start_before_ = std::chrono::steady_clock::now() + pause_for_space_;
  log_error("-", "the disk is full: no run is started for {} s", pause_for_space_.count() / 1000);
}

/// Workers are asked to end; what has a result by then is taken in. Runs of a cluster go on and
/// are adopted at the next start.
void Dispatcher::wind_down() {
  if (executor_->outlives_server()) return;
  for (const auto& [run, of] : runs_) executor_->cancel(run);
  const auto until = std::chrono::steady_clock::now() + to_wind_down;
  while (!runs_.empty() && std::chrono::steady_clock::now() < until) {
    for (const auto& end : executor_->poll()) {
      const auto run = runs_.find(end.run);
      if (run == runs_.end()) continue;
      try {
        if (end.how == RunEnd::How::exited && end.exit_code == 0) {
          settle({end, read_outcome(data_.run(end.run))});
        }
      } catch (const std::exception& error) {
        log_error("-", "result left for the next start run={} reason={}", end.run,
                  in_quotes(error.what()));
      }
      runs_.erase(end.run);  // without a result its row stays running, for the next start
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace leda::server
