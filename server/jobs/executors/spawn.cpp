#include "server/jobs/executors/spawn.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>
#include <utility>

namespace leda::server {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int look_again_ms = 50;  // at `stop` and the clock

class Pipe {
 public:
  Pipe() : sound_(pipe2(ends_.data(), O_CLOEXEC) == 0) {}
  ~Pipe() {
    close_read();
    close_write();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  bool sound() const { return sound_; }
  int read_end() const { return ends_[0]; }
  int write_end() const { return ends_[1]; }
  void close_read() { close_one(ends_[0]); }
  void close_write() { close_one(ends_[1]); }

 private:
  static void close_one(int& file) {
    if (file >= 0) close(file);
    file = -1;
  }
  std::array<int, 2> ends_{-1, -1};
  bool sound_;
};

/// What the child does before it becomes the program.
class Preparation {
 public:
  Preparation(int out, int errors) {
    posix_spawn_file_actions_init(&files_);
    posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&files_, out, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files_, errors, STDERR_FILENO);
    posix_spawn_file_actions_addclosefrom_np(&files_, 3);
    posix_spawnattr_init(&attributes_);
    sigset_t none, defaults;
    sigemptyset(&none);
    sigemptyset(&defaults);
    sigaddset(&defaults, SIGPIPE);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setsigdefault(&attributes_, &defaults);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~Preparation() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }
  Preparation(const Preparation&) = delete;
  Preparation& operator=(const Preparation&) = delete;

  const posix_spawn_file_actions_t* files() const { return &files_; }
  const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t files_{};
  posix_spawnattr_t attributes_{};
};

/// Takes what has come. Closes the pipe at its end.
void take(Pipe& from, std::string& text) {
  std::array<char, 65536> part{};
  const ssize_t count = read(from.read_end(), part.data(), part.size());
  if (count > 0) text.append(part.data(), static_cast<std::size_t>(count));
  if (count == 0) from.close_read();
}

/// Reads both pipes to their ends. False where time ran out.
bool listen(Pipe& out, Pipe& errors, Said& said, Clock::time_point until,
            const std::atomic<bool>& stop) {
  while (out.read_end() >= 0 || errors.read_end() >= 0) {
    if (stop || Clock::now() > until) return false;
    std::array<pollfd, 2> files{pollfd{out.read_end(), POLLIN, 0},
                                pollfd{errors.read_end(), POLLIN, 0}};
    if (poll(files.data(), files.size(), look_again_ms) <= 0) continue;
    if (files[0].revents != 0) take(out, said.out);
    if (files[1].revents != 0) take(errors, said.errors);
  }
  return true;
}

}  // namespace

Said ask_program(std::vector<std::string> arguments, std::chrono::milliseconds patience,
                 const std::atomic<bool>& stop) {
  Said said;
  const auto until = Clock::now() + patience;
  Pipe out, errors;
  if (!out.sound() || !errors.sound()) {
    said.errors = "no pipe for " + arguments.front();
    return said;
  }
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (auto& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  const Preparation preparation(out.write_end(), errors.write_end());
  pid_t child = 0;
  const int fault = posix_spawnp(&child, argv[0], preparation.files(), preparation.attributes(),
                                 argv.data(), environ);
  if (fault != 0) {
    said.errors = arguments.front() + " could not be started: " + std::strerror(fault);
    return said;
  }
  out.close_write();
  errors.close_write();
  said.ended = listen(out, errors, said, until, stop);
  if (!said.ended) kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  said.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return said;
}

}  // namespace leda::server
