// One task of a Slurm job array: finds its run in the array's note and becomes the run.

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <charconv>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "server/commands/commands.hpp"
#include "server/commands/exit_code.hpp"
#include "server/jobs/executors/executor.hpp"
#include "server/jobs/executors/slurm/array_notes.hpp"

namespace leda::server {
namespace {

struct Options {
  std::filesystem::path script;
  std::filesystem::path note;
};

std::size_t task_index() {
  const char* text = std::getenv("SLURM_ARRAY_TASK_ID");
  std::size_t index = 0;
  const char* end = text == nullptr ? nullptr : text + std::strlen(text);
  if (text == nullptr || std::from_chars(text, end, index).ptr != end || text == end) {
    throw std::runtime_error("SLURM_ARRAY_TASK_ID is not a number: this is called by Slurm");
  }
  return index;
}

void limit(decltype(RLIMIT_AS) what, rlim_t soft, rlim_t hard) {
  const rlimit value{soft, hard};
  setrlimit(what, &value);
}

void apply(const RunLimits& limits) {
  limit(RLIMIT_CORE, 0, 0);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // their shadow is terabytes
  if (limits.memory_bytes > 0) limit(RLIMIT_AS, limits.memory_bytes, limits.memory_bytes);
#endif
  if (limits.cpu_s > 0) limit(RLIMIT_CPU, limits.cpu_s, limits.cpu_s + 5);
}

/// From here on, what the run says goes to its own log.
void write_to(const std::filesystem::path& log) {
  const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (file < 0) {
    throw std::runtime_error(fmt::format("{}: {}", log.string(), std::strerror(errno)));
  }
  dup2(file, STDOUT_FILENO);
  dup2(file, STDERR_FILENO);
  close(file);
}

int array_task(const Options& options) {
  const ArrayNote note = read_note(options.note);
  const std::size_t index = task_index();
  if (index >= note.folders.size()) {
    throw std::runtime_error(fmt::format("{} has no task {}, only {}", options.note.string(), index,
                                         note.folders.size()));
  }
  std::string program = note.program.string();
  auto words = worker_arguments({"", note.folders[index]});
  std::vector<char*> arguments{program.data()};
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  write_to(note.folders[index] / "log.txt");
  apply(note.limits);
  execv(program.c_str(), arguments.data());
  fmt::print(stderr, "the program of the run could not be started: {}: {}\n", program,
             std::strerror(errno));
  return 127;
}

}  // namespace

void add_array_task(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("array-task", "One run of a Slurm array; called by Slurm");
  command->group("");  // not shown: nobody calls it
  command->add_option("script", options->script, "what Slurm started")->required();
  command->add_option("note", options->note, "what the tasks of the array compute")->required();
  command->callback(
      [options, &exit_code] { exit_code = guarded([&] { return array_task(*options); }); });
}

}  // namespace leda::server
