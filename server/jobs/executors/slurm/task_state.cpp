#include "server/jobs/executors/slurm/task_state.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <cstring>

namespace leda::server {
namespace {

/// Calls `use` with every part of a text between separators.
template <class Use>
void for_each_part(std::string_view text, char separator, Use use) {
  while (!text.empty()) {
    const auto end = std::min(text.find(separator), text.size());
    use(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number value{};
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// "3:0" is exit code 3, "0:9" signal 9.
void read_exit_code(std::string_view text, TaskState& task) {
  const auto colon = text.find(':');
  if (colon == std::string_view::npos) return;
  task.exit_code = number_in<int>(text.substr(0, colon)).value_or(0);
  task.signal = number_in<int>(text.substr(colon + 1)).value_or(0);
}

std::string words_of(const std::string& state) {
  if (state == "NODE_FAIL" || state == "BOOT_FAIL") return "the node of the run failed";
  if (state == "PREEMPTED") return "the run had to make room for another";
  if (state == "CANCELLED" || state == "REVOKED") return "the run was cancelled in Slurm";
  return "Slurm ended the run: " + state;
}

}  // namespace

bool TaskState::is_over() const {
  constexpr std::array going{"PENDING",       "RUNNING",     "CONFIGURING",  "COMPLETING",
                             "SUSPENDED",     "STOPPED",     "STAGE_OUT",    "RESIZING",
                             "SIGNALING",     "REQUEUED",    "REQUEUE_HOLD", "REQUEUE_FED",
                             "RESV_DEL_HOLD", "SPECIAL_EXIT"};
  return std::none_of(going.begin(), going.end(), [this](const char* one) { return state == one; });
}

std::map<TaskKey, TaskState> read_queue(std::string_view text) {
  std::map<TaskKey, TaskState> found;
  for_each_part(text, '\n', [&](std::string_view line) {
    std::array<std::string_view, 4> fields{};
    std::size_t count = 0;
    for_each_part(line, '|', [&](std::string_view field) {
      if (count < fields.size()) fields[count] = field;
      ++count;
    });
    const auto task = number_in<std::size_t>(fields[1]);
    if (count != fields.size() || !task) return;
    found[{std::string(fields[3]), *task}] = {std::string(fields[0]), std::string(fields[2])};
  });
  return found;
}

std::map<TaskKey, TaskState> read_records(std::string_view text) {
  std::map<TaskKey, TaskState> found;
  for_each_part(text, '\n', [&](std::string_view line) {
    TaskState task;
    std::string name;
    std::optional<std::size_t> index;
    for_each_part(line, ' ', [&](std::string_view field) {
      const auto equals = field.find('=');
      if (equals == std::string_view::npos) return;
      const auto key = field.substr(0, equals), value = field.substr(equals + 1);
      if (key == "ArrayJobId") task.array_id = value;
      if (key == "ArrayTaskId") index = number_in<std::size_t>(value);
      if (key == "JobName" || key == "Name") name = value;
      if (key == "JobState") task.state = value;
      if (key == "ExitCode") read_exit_code(value, task);
    });
    if (!name.empty() && index && !task.state.empty()) found[{name, *index}] = task;
  });
  return found;
}

RunEnd end_of(const std::string& run, const TaskState& task, bool asked, bool begun) {
  RunEnd end{run, RunEnd::How::exited, task.exit_code, ""};
  const bool by_itself = task.state == "COMPLETED" || (task.state == "FAILED" && task.signal == 0);
  if (by_itself) {
    if (end.exit_code != 0) {
      end.reason = "the worker ended with code " + std::to_string(end.exit_code);
    }
  } else if (asked) {
    end.how = RunEnd::How::cancelled;
    end.reason = "cancelled";
  } else if (task.state == "TIMEOUT" || task.state == "DEADLINE") {
    end = out_of_time(run, begun);
  } else if (task.state == "OUT_OF_MEMORY") {
    end.how = RunEnd::How::over_limit;
    end.reason = "the run used more memory than it may";
  } else if (task.signal == SIGXCPU) {
    end.how = RunEnd::How::over_limit;
    end.reason = "the run used more processor time than it may";
  } else {
    end.how = RunEnd::How::killed;
    end.reason = task.state == "FAILED"
                     ? "the worker died of signal " + std::to_string(task.signal) + " (" +
                           strsignal(task.signal) + ")"
                     : words_of(task.state);
  }
  return end;
}

std::string array_range(const std::vector<std::size_t>& indices) {
  std::string text;
  for (std::size_t i = 0; i < indices.size();) {
    std::size_t last = i;
    while (last + 1 < indices.size() && indices[last + 1] == indices[last] + 1) ++last;
    if (!text.empty()) text += ',';
    text += std::to_string(indices[i]);
    if (last > i) text += '-' + std::to_string(indices[last]);
    i = last + 1;
  }
  return text;
}

}  // namespace leda::server
