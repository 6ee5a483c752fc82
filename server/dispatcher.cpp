#include "server/dispatcher.hpp"

#include <algorithm>

#include "server/documents/run_folder.hpp"
#include "server/logging.hpp"
#include "server/problem.hpp"
#include "server/summary.hpp"

namespace leda::server {

using db::JobState;
using db::SectionState;

namespace {

constexpr int most_starts_a_turn = 50;
constexpr std::chrono::milliseconds between_turns{50};
constexpr std::chrono::milliseconds after_failure{1000};
constexpr std::chrono::milliseconds to_wind_down{2500};

/// A folder that no earlier try has used, not even one that died before it was stored.
std::string new_run(const DataFolder& data, const std::string& job,
                    const db::SectionRecord& section) {
  for (int number = section.attempts + 1;; ++number) {
    std::string run = job + "-" + std::to_string(section.ordinal) + "-" + std::to_string(number);
    if (std::filesystem::create_directory(data.run(run))) return run;
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
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void Dispatcher::start() {
  const std::lock_guard lock(mutex_);
  for (const auto& job : store_.unfinished_jobs()) to_take_up_.push_back(job.id);
  thread_ = std::thread([this] { work(); });
}

void Dispatcher::add(const std::string& job) {
  const std::lock_guard lock(mutex_);
  to_take_up_.push_back(job);
  wake_.notify_all();
}

std::size_t Dispatcher::running() const {
  const std::lock_guard lock(mutex_);
  return runs_.size();
}

std::chrono::steady_clock::duration Dispatcher::since_last_turn() const {
  return std::chrono::steady_clock::now() - last_turn_.load();
}

void Dispatcher::dismiss(const std::string& id) {
  const std::lock_guard lock(mutex_);
  std::erase(to_take_up_, id);
  store_.set_job_state(id, JobState::dismissed, "dismissed");
  const auto found = jobs_.find(id);
  if (found != jobs_.end()) {
    for (const auto& [run, of] : runs_) {
      if (of.job == id) executor_->cancel(run);
    }
    std::erase_if(runs_, [&](const auto& entry) { return entry.second.job == id; });
    jobs_.erase(found);
  }
  for (const auto& section : store_.sections(id)) {
    if (section.state == SectionState::waiting || section.state == SectionState::running) {
      store_.set_section_state(section.id, SectionState::dismissed, "the job was dismissed");
    }
  }
  log_info(id, "dismissed");
}

void Dispatcher::work() {
  std::unique_lock lock(mutex_);
  while (!stop_) {
    auto pause = between_turns;
    try {
      if (!executor_) executor_ = make_executor_();
      turn();
      last_turn_ = std::chrono::steady_clock::now();
    } catch (const std::exception& error) {
      log_error("-", "dispatcher tries again reason={}", in_quotes(error.what()));
      pause = after_failure;
    }
    wake_.wait_for(lock, pause, [this] { return stop_ || !to_take_up_.empty(); });
  }
  if (executor_) wind_down();
  executor_.reset();
}

void Dispatcher::turn() {
  while (!to_take_up_.empty()) {
    take_up(to_take_up_.front());
    to_take_up_.pop_front();
  }
  for (auto& end : executor_->poll()) ended_.push_back(std::move(end));
  while (!ended_.empty()) {
    settle(ended_.front());
    ended_.pop_front();
  }
  // A limit, because screening may finish thousands of sections without ever filling a slot, and
  // the jobs of others wait for the lock meanwhile.
  for (int i = 0; i < most_starts_a_turn && executor_->free_slots() > 0 && start_next(); ++i) {
  }
  report_progress();
  finish_done_jobs();
}

void Dispatcher::take_up(const std::string& id) {
  const auto record = store_.job(id);
  if (!record || jobs_.contains(id)) return;
  if (record->state != JobState::accepted && record->state != JobState::running) return;
  OpenJob job;
  job.record = *record;
  try {
    const Process* process = find_process(record->process);
    if (process == nullptr) throw std::runtime_error("no process " + record->process);
    job.work = process->open(record->request, {data_, store_, record->raster});
    job.sections = store_.sections(id);
    if (job.sections.empty()) {
      store_.set_sections(id, job.work->plan());
      job.sections = store_.sections(id);
    }
  } catch (const db::StoreError&) {
    throw;
  } catch (const std::exception& error) {
    log_error(id, "cannot be taken up reason={}", in_quotes(error.what()));
    store_.set_job_state(id, JobState::failed,
                         std::string("the job could not be taken up: ") + error.what());
    return;
  }
  recover(job);
  log_info(id, "taken up sections={} waiting={}", job.sections.size(),
           count(job.sections, SectionState::waiting));
  jobs_[id] = std::move(job);
}

/// The job with the fewest runs comes first, so that a small one need not wait for a large one.
bool Dispatcher::start_next() {
  OpenJob* next = nullptr;
  for (auto& [id, job] : jobs_) {
    if (count(job.sections, SectionState::waiting) == 0) continue;
    const bool sooner = next == nullptr || job.running < next->running ||
                        (job.running == next->running && job.record.created < next->record.created);
    if (sooner) next = &job;
  }
  if (next == nullptr) return false;
  const auto section =
      std::find_if(next->sections.begin(), next->sections.end(),
                   [](const auto& candidate) { return candidate.state == SectionState::waiting; });
  if (!screened_out(*next, *section)) {
    start_run(*next, static_cast<std::size_t>(section - next->sections.begin()));
  }
  return true;
}

/// Screens a section that was not screened yet. True where it needs no run: it is stable then.
bool Dispatcher::screened_out(OpenJob& job, db::SectionRecord& section) {
  if (!section.screening.empty()) return false;
  const auto screened = job.work->screen(section);
  if (!screened) return false;
  store_.set_screening(section.id, screened->document);
  section.screening = screened->document;
  if (!screened->skip) return false;
  section.reason = "not simulated: " + screened->reason;
  store_.set_section_state(section.id, SectionState::stable, section.reason);
  section.state = SectionState::stable;
  return true;
}

void Dispatcher::start_run(OpenJob& job, std::size_t index) {
  db::SectionRecord& section = job.sections[index];
  const std::string& id = job.record.id;
  const std::string run = new_run(data_, id, section);
  write_whole(data_.run(run) / "case.json", job.work->case_file(section));
  store_.start_run(section.id, run);
  section.run = run;
  section.state = SectionState::running;
  ++section.attempts;
  if (job.record.state == JobState::accepted) {
    store_.set_job_state(id, JobState::running, progress_message(job.sections));
    job.record.state = JobState::running;
  }
  runs_[run] = {id, index};
  ++job.running;
  executor_->submit({run, data_.run(run)});
  log_info(id, "run started section={} run={}", in_quotes(section.name), run);
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
      if (end.how == RunEnd::How::exited && end.exit_code == 0) {
        settle(end);
      } else {
        runs_.erase(run);  // its row stays running, and is taken up at the next start
      }
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace leda::server
