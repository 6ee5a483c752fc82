// The three things a look at the queue leads to: arrays are started, ended tasks are told, and
// cancelled ones are ended.

#include <algorithm>

#include "server/jobs/executors/slurm/slurm_executor.hpp"
#include "server/operate/logging.hpp"

namespace leda::server {
namespace {

bool has_result(const std::filesystem::path& folder) {
  std::error_code unknown;
  return std::filesystem::exists(folder / "result.json", unknown);
}

/// Slurm's number of an array that is in the queue; empty: it is not.
std::string id_in(const Cluster::States& queue, const std::string& name) {
  const auto first = queue.lower_bound({name, 0});
  return first != queue.end() && first->first.first == name ? first->second.array_id : "";
}

}  // namespace

/// Hands an array to Slurm. Where it may have been handed over before (a server that died, or an
/// sbatch that got no answer), the queue tells, and what left a result since is not run again.
/// @return whether the queue, read before, does not show the array yet
bool SlurmExecutor::start(const std::string& name, const Cluster::States& queue) {
  ArrayNote note;
  std::vector<std::size_t> indices;
  {
    const std::lock_guard lock(mutex_);
    Array& array = arrays_.at(name);
    if (!array.note.id.empty()) return false;
    array.note.id = id_in(queue, name);
    for (std::size_t i = 0; array.note.id.empty() && i < array.tasks.size(); ++i) {
      Task& task = array.tasks[i];
      if (task.over) continue;
      if (array.asked && has_result(task.folder)) {
        tell(task, {task.run, RunEnd::How::exited, 0, ""});
      } else if (task.cancelled) {
        tell(task, {task.run, RunEnd::How::cancelled, 0, "cancelled"});
      } else {
        indices.push_back(i);
      }
    }
    array.asked = true;
    note = array.note;
  }
  Cluster::Answer answer{Cluster::Answer::Kind::accepted, note.id};
  if (note.id.empty() && indices.empty()) return true;
  const bool is_new = note.id.empty();
  if (is_new) answer = cluster_.submit(notes_, note, indices);

  const std::lock_guard lock(mutex_);
  Array& array = arrays_.at(name);
  if (answer.kind == Cluster::Answer::Kind::accepted) {
    array.note.id = answer.text;
    notes_.write(array.note);
    log_info("-", "array in slurm name={} id={} tasks={}", name, answer.text, array.tasks.size());
  } else if (answer.kind == Cluster::Answer::Kind::refused) {
    log_error("-", "slurm refuses an array reason={}", in_quotes(answer.text));
    for (const std::size_t i : indices) {
      tell(array.tasks[i],
           {array.tasks[i].run, RunEnd::How::killed, 0, "Slurm refuses the run: " + answer.text});
    }
  } else {
    log_warning("-", "slurm takes no array now reason={}", in_quotes(answer.text));
  }
  return is_new;
}

/// Tells the ends of tasks that were in the queue before and are not any more.
void SlurmExecutor::settle(const std::string& name, const Cluster::States& queue) {
  std::string id;
  {
    const std::lock_guard lock(mutex_);
    Array& array = arrays_.at(name);
    bool any_gone = false;
    for (std::size_t i = 0; i < array.tasks.size(); ++i) {
      Task& task = array.tasks[i];
      const bool queued = queue.contains({name, i});
      if (queued) task.gone.reset();
      any_gone = any_gone || (!task.over && !queued);
    }
    if (!any_gone) return;
    id = array.note.id;
  }
  if (id.empty()) return;
  const auto records = cluster_.records(name, id);
  if (!records) return;
  const std::lock_guard lock(mutex_);
  Array& array = arrays_.at(name);
  for (std::size_t i = 0; i < array.tasks.size(); ++i) {
    if (!array.tasks[i].over && !queue.contains({name, i})) {
      end_task(array.tasks[i], *records, name, i);
    }
  }
}

void SlurmExecutor::end_task(Task& task, const Cluster::States& records, const std::string& name,
                             std::size_t index) {
  const auto record = records.find({name, index});
  const bool known = record != records.end();
  if (known && !record->second.is_over()) {
    task.gone.reset();
    return;
  }
  const auto now = Clock::now();
  if (!task.gone) task.gone = now;
  const bool says_done = known && record->second.state == "COMPLETED";
  const bool there = has_result(task.folder);
  // Files of another machine may show later than the end of the task that wrote them.
  if ((says_done || !known) && !there && now - *task.gone < settings_.settle) return;
  if (known) {
    tell(task, server::end_of(task.run, record->second, task.cancelled, has_begun(task.folder)));
  } else if (there) {
    tell(task, {task.run, RunEnd::How::exited, 0, ""});
  } else if (task.cancelled) {
    tell(task, {task.run, RunEnd::How::cancelled, 0, "cancelled"});
  } else {
    tell(task, {task.run, RunEnd::How::killed, 0, "Slurm does not know the run any more"});
  }
}

void SlurmExecutor::cancel_in(const Cluster::States& queue) {
  std::vector<std::string> tasks;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [name, array] : arrays_) {
      for (std::size_t i = 0; i < array.tasks.size(); ++i) {
        const auto found = queue.find({name, i});
        if (!array.tasks[i].cancelled || array.tasks[i].over || found == queue.end()) continue;
        if (found->second.state == "COMPLETING") continue;
        tasks.push_back(found->second.array_id + "_" + std::to_string(i));
      }
    }
  }
  if (!tasks.empty()) cluster_.cancel(tasks);
}

}  // namespace leda::server
