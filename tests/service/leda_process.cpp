#include "tests/service/leda_process.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "tests/server/temporary_folder.hpp"

namespace leda::tests {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

std::string read_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();  // keeps to itself that a process in /proc has gone meanwhile
  return text.str();
}

constexpr int not_installed = 127;

pid_t start(std::string program, std::vector<std::string> arguments,
            const std::filesystem::path& out, const std::filesystem::path& errors) {
  std::vector<char*> argv{program.data()};
  for (auto& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644), STDOUT_FILENO);
    dup2(open(errors.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644), STDERR_FILENO);
    execvp(argv[0], argv.data());
    _exit(not_installed);
  }
  if (child < 0) throw std::runtime_error("fork failed");
  return child;
}

}  // namespace

LedaServer::LedaServer(const std::filesystem::path& data, const std::vector<std::string>& more) {
  std::filesystem::create_directories(data);
  std::vector<std::string> arguments{"serve", "--data", data.string(), "--listen", "127.0.0.1:0"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto errors = data / "server.log";
  std::filesystem::remove(data / "server.json");
  process_ = start(LEDA_PROGRAM, arguments, data / "server.out", errors);
  const auto until = Clock::now() + 30s;
  while (Clock::now() < until && is_alive(process_)) {
    const auto where = nlohmann::json::parse(read_text(data / "server.json"), nullptr, false);
    if (where.is_object()) {
      url_ = where["url"];
      client_ = std::make_unique<httplib::Client>(url_);
      client_->set_read_timeout(60s);
      if (client_->Get("/readyz")) return;
    }
    std::this_thread::sleep_for(10ms);
  }
  kill_hard();
  throw std::runtime_error("leda serve did not start: " + read_text(errors));
}

LedaServer::~LedaServer() { kill_hard(); }

void LedaServer::kill_hard() {
  if (process_ == 0) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
  process_ = 0;
}

double LedaServer::end() {
  const auto start_of_end = Clock::now();
  kill(process_, SIGTERM);
  waitpid(process_, nullptr, 0);
  process_ = 0;
  return std::chrono::duration<double>(Clock::now() - start_of_end).count();
}

std::vector<pid_t> LedaServer::workers() const {
  std::vector<pid_t> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    const std::string stat = read_text(entry.path() / "stat");
    const auto after_name = stat.rfind(')');
    if (after_name == std::string::npos) continue;
    std::istringstream fields(stat.substr(after_name + 1));
    char state = 0;
    pid_t parent = 0;
    fields >> state >> parent;
    if (parent == process_ && state != 'Z') found.push_back(std::stoi(name));
  }
  return found;
}

nlohmann::json LedaServer::get(const std::string& path) {
  const auto answer = client_->Get(path);
  if (!answer) throw std::runtime_error("no answer to " + path);
  if (answer->status != 200) {
    throw std::runtime_error(path + " answers " + std::to_string(answer->status) + ": " +
                             answer->body);
  }
  return nlohmann::json::parse(answer->body);
}

nlohmann::json LedaServer::wait_for_job(const std::string& job, std::chrono::seconds patience) {
  const auto until = Clock::now() + patience;
  for (;;) {
    auto status = get("/jobs/" + job);
    const bool finished = status["status"] != "accepted" && status["status"] != "running";
    if (finished || Clock::now() > until) return status;
    std::this_thread::sleep_for(100ms);
  }
}

Output run_leda(const std::vector<std::string>& arguments) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "out";
  const auto errors = folder.path() / "errors";
  int status = 0;
  waitpid(start(LEDA_PROGRAM, arguments, out, errors), &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(out), read_text(errors)};
}

std::optional<Output> run_program(const std::vector<std::string>& arguments) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "out";
  const auto errors = folder.path() / "errors";
  int status = 0;
  const std::vector<std::string> others(arguments.begin() + 1, arguments.end());
  waitpid(start(arguments.front(), others, out, errors), &status, 0);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (code == not_installed) return std::nullopt;
  return Output{code, read_text(out), read_text(errors)};
}

std::filesystem::path run_folder_of(pid_t worker) {
  const std::string command = read_text("/proc/" + std::to_string(worker) + "/cmdline");
  const std::string option = std::string("--out") + '\0';
  const auto at = command.find(option);
  return at == std::string::npos ? "" : command.c_str() + at + option.size();
}

char state_of(pid_t process) {
  const std::string stat = read_text("/proc/" + std::to_string(process) + "/stat");
  const auto after_name = stat.rfind(')');
  return after_name == std::string::npos || after_name + 2 >= stat.size() ? '\0'
                                                                          : stat[after_name + 2];
}

bool is_alive(pid_t process) { return state_of(process) != 0 && state_of(process) != 'Z'; }

}  // namespace leda::tests
