#include "server/jobs/executors/slurm/slurm_executor.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "server/operate/logging.hpp"
#include "server/run/run_folder.hpp"

namespace leda::server {
namespace {

RunEnd cancelled(const std::string& run) { return {run, RunEnd::How::cancelled, 0, "cancelled"}; }

}  // namespace

SlurmExecutor::SlurmExecutor(std::filesystem::path program, SlurmSettings settings,
                             RunLimits limits, const std::filesystem::path& notes)
    : settings_(std::move(settings)),
      limits_(limits),
      program_(std::move(program)),
      notes_(notes),
      cluster_(settings_, limits_, stop_) {
  std::string faults;
  for (const auto& fault : faults_of(settings_)) faults += (faults.empty() ? "" : "; ") + fault;
  if (!faults.empty()) throw std::runtime_error(faults);
  // Slurm starts a script, and the script's interpreter is leda itself: no shell.
  disk::write_whole(notes_.batch_script(), "#!" + settings_.program.string() + " array-task\n");
  for (ArrayNote& note : notes_.read()) {
    Array array;
    for (const auto& folder : note.folders) {
      array.tasks.push_back(
          {.run = folder.filename().string(), .folder = folder, .adopted = false});
    }
    array.asked = true;
    array.note = std::move(note);
    add(std::move(array));
  }
}

SlurmExecutor::~SlurmExecutor() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
}

std::size_t SlurmExecutor::free_slots() const {
  const std::lock_guard lock(mutex_);
  return settings_.most_queued > held_ ? settings_.most_queued - held_ : 0;
}

void SlurmExecutor::submit(const RunOrder& order) {
  const std::lock_guard lock(mutex_);
  std::error_code unknown;
  const auto real = std::filesystem::canonical(order.folder, unknown);  // as the nodes reach it
  orders_.push_back({order.run, unknown ? order.folder : real});
  last_order_ = Clock::now();
  ++held_;
  wake_.notify_all();
}

bool SlurmExecutor::adopt(const RunOrder& order) {
  const std::lock_guard lock(mutex_);
  Task* task = task_of(order.run);
  if (task == nullptr || task->over || task->cancelled) return false;
  if (!task->adopted) ++held_;
  task->adopted = true;
  return true;
}

void SlurmExecutor::cancel(const std::string& run) {
  const std::lock_guard lock(mutex_);
  const auto waiting = std::find_if(orders_.begin(), orders_.end(),
                                    [&](const RunOrder& order) { return order.run == run; });
  if (waiting != orders_.end()) {
    orders_.erase(waiting);
    ended_.push_back(cancelled(run));
  } else if (Task* task = task_of(run)) {
    task->cancelled = true;
  }
  wake_.notify_all();
}

std::vector<RunEnd> SlurmExecutor::poll() {
  const std::lock_guard lock(mutex_);
  if (!thread_.joinable()) {
    give_up_orphans();
    thread_ = std::thread([this] { follow(); });
  }
  held_ -= ended_.size();
  return std::exchange(ended_, {});
}

void SlurmExecutor::give_up_orphans() {
  for (auto& [name, array] : arrays_) {
    for (Task& task : array.tasks) task.cancelled = task.cancelled || !task.adopted;
  }
}

void SlurmExecutor::follow() {
  auto looked = Clock::time_point{};
  while (!stop_) {
    {
      std::unique_lock lock(mutex_);
      const auto is_due = [&] {
        return stop_ || is_gathered() || Clock::now() - looked >= settings_.look_every;
      };
      while (!is_due()) wake_.wait_for(lock, std::chrono::milliseconds(50));
    }
    if (stop_) return;
    looked = Clock::now();
    try {
      look();
    } catch (const std::exception& fault) {
      log_error("-", "slurm tries again reason={}", in_quotes(fault.what()));
    }
  }
}

/// Enough runs for an array, or none came for a moment.
bool SlurmExecutor::is_gathered() const {
  if (orders_.empty()) return false;
  return orders_.size() >= settings_.max_array_size ||
         Clock::now() - last_order_ >= settings_.gather;
}

void SlurmExecutor::make_arrays() {
  const std::lock_guard lock(mutex_);
  if (!is_gathered()) return;
  while (!orders_.empty()) {
    const auto count = static_cast<std::ptrdiff_t>(
        std::min(orders_.size(), std::max<std::size_t>(1, settings_.max_array_size)));
    Array array;
    array.note = {notes_.new_name(), "", program_, limits_, {}};
    for (auto order = orders_.begin(); order != orders_.begin() + count; ++order) {
      array.note.folders.push_back(order->folder);
      array.tasks.push_back({.run = order->run, .folder = order->folder});
    }
    notes_.write(array.note);
    add(std::move(array));
    orders_.erase(orders_.begin(), orders_.begin() + count);
  }
}

/// One look at the cluster: starts what is new, tells what ended, ends what was cancelled.
void SlurmExecutor::look() {
  make_arrays();
  std::vector<std::string> names;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [name, array] : arrays_) names.push_back(name);
  }
  if (names.empty()) return;
  const auto queue = cluster_.queue(notes_.prefix());
  if (stop_) return;
  if (queue.has_value() != answered_) {
    answered_ = queue.has_value();
    if (answered_) log_info("-", "slurm answers again");
    if (!answered_) log_warning("-", "slurm does not answer reason={}", in_quotes(cluster_.why()));
  }
  if (!queue) return;
  for (const auto& name : names) {
    if (!start(name, *queue)) settle(name, *queue);
  }
  cancel_in(*queue);
  const std::lock_guard lock(mutex_);
  forget_finished();
}

void SlurmExecutor::forget_finished() {
  std::erase_if(arrays_, [this](const auto& entry) {
    const auto& tasks = entry.second.tasks;
    const bool over = std::all_of(tasks.begin(), tasks.end(), [](const Task& t) { return t.over; });
    if (!over) return false;
    notes_.remove(entry.first);
    for (const Task& task : tasks) tasks_.erase(task.run);
    return true;
  });
}

SlurmExecutor::Task* SlurmExecutor::task_of(const std::string& run) {
  const auto found = tasks_.find(run);
  return found == tasks_.end() ? nullptr : found->second;
}

void SlurmExecutor::add(Array array) {
  const std::string name = array.note.name;
  Array& kept = arrays_.emplace(name, std::move(array)).first->second;
  for (Task& task : kept.tasks) tasks_[task.run] = &task;
}

void SlurmExecutor::tell(Task& task, RunEnd end) {
  task.over = true;
  if (task.adopted) ended_.push_back(std::move(end));
}

}  // namespace leda::server
