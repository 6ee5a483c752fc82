// The dispatcher's thread: what reaches it from handlers, and the order of its turns.

#include "server/jobs/dispatcher.hpp"

#include <algorithm>

#include "server/operate/logging.hpp"
#include "server/operate/memory_return.hpp"
#include "server/run/run_checkpoint.hpp"

namespace leda::server {

using db::JobState;
using db::SectionState;

namespace {

constexpr std::chrono::milliseconds between_turns{50};
constexpr std::chrono::milliseconds after_failure{1000};
constexpr std::chrono::milliseconds to_wind_down{3500};

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
  store_.dismiss_job(job);
  {
    const std::lock_guard lock(inbox_mutex_);
    std::erase(to_take_up_, job);
    to_let_go_.push_back(job);
  }
  wake_.notify_all();
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
    wake_.wait_for(inbox, pause,
                   [this] { return stop_ || !to_take_up_.empty() || !to_let_go_.empty(); });
    stopped = stop_;
  }
  if (executor_) wind_down();
  executor_.reset();
}

void Dispatcher::turn() {
  if (!executor_) executor_ = make_executor_();
  take_up_new_jobs();
  settle_ended_runs();
  start_runs();
  book_started_jobs();
  report_progress();
  finish_done_jobs();
}

/// What is dismissed while a turn goes on costs no more than the step it is in. The store has kept
/// what came in between from such a job already.
void Dispatcher::let_go_dismissed_jobs() {
  std::vector<std::string> dismissed;
  {
    const std::lock_guard inbox(inbox_mutex_);
    dismissed.swap(to_let_go_);
  }
  for (const auto& job : dismissed) let_go(job);
}

void Dispatcher::let_go(const std::string& job) {
  if (jobs_.erase(job) == 0) return;
  for (const auto& [run, of] : runs_) {
    if (of.job == job) executor_->cancel(run);
  }
  std::erase_if(runs_, [&](const auto& entry) { return entry.second.job == job; });
  running_ = runs_.size();
}

/// A job leaves the inbox when it was taken up: where the store fails it is tried again.
void Dispatcher::take_up_new_jobs() {
  for (;;) {
    let_go_dismissed_jobs();
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
  const MemoryReturn after_opening;
  auto job = open(id);
  if (!job) return;
  recover(*job);
  log_info(id, "taken up sections={} waiting={}", job->sections.size(),
           job->sections.counts().of(SectionState::waiting));
  jobs_[id] = std::move(*job);
}

/// Nothing where the job is finished or known already, or cannot be understood.
std::optional<Dispatcher::OpenJob> Dispatcher::open(const std::string& id) {
  if (jobs_.contains(id)) return std::nullopt;
  auto record = store_.job(id);
  if (!record || db::is_final(record->state)) return std::nullopt;
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
        if (end.how == RunEnd::How::exited && end.exit_code == 0) settle(end);
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
