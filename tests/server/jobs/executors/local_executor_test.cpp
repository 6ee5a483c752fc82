#include "server/jobs/executors/local_executor.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "tests/server/jobs/executors/executor_suite.hpp"
#include "tests/server/temporary_folder.hpp"

namespace leda::server {
namespace {

using namespace std::chrono_literals;

using tests::ExecutorKind;
using tests::ExecutorSuite;

INSTANTIATE_TEST_SUITE_P(Local, ExecutorSuite,
                         testing::Values(ExecutorKind{
                             "local",
                             [](const auto& program, const auto& limits, const auto&) {
                               return std::make_unique<LocalExecutor>(program, 2, limits);
                             }}),
                         [](const auto& kind) { return kind.param.name; });

/// What only processes of this machine promise.
class LocalExecutorTest : public testing::Test {
 protected:
  std::filesystem::path program(const std::string& body) {
    auto file = folder.path() / "worker.sh";
    std::ofstream(file) << "#!/bin/sh\n" << body << "\n";
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    return file;
  }

  RunOrder order(const std::string& run) {
    std::filesystem::create_directory(folder.path() / run);
    return {run, folder.path() / run};
  }

  static RunEnd wait_for_end(Executor& executor) {
    const auto until = std::chrono::steady_clock::now() + 20s;
    while (std::chrono::steady_clock::now() < until) {
      auto ended = executor.poll();
      if (!ended.empty()) return ended.front();
      std::this_thread::sleep_for(10ms);
    }
    return {"none", RunEnd::How::exited, -1, "the run did not end"};
  }

  std::string text(const std::filesystem::path& file) {
    std::ifstream in(folder.path() / file);
    std::stringstream all;
    all << in.rdbuf();
    return all.str();
  }

  tests::TemporaryFolder folder;
};

TEST_F(LocalExecutorTest, WorkersDieWithTheServer) {
  const auto script = program("echo $$ > $4/pid; exec sleep 60");
  const RunOrder run = order("r");
  const pid_t server = fork();
  ASSERT_GE(server, 0);
  if (server == 0) {
    LocalExecutor executor(script, 1);
    executor.submit(run);
    for (;;) pause();
  }
  while (text("r/pid").empty()) std::this_thread::sleep_for(10ms);
  const pid_t worker = std::stoi(text("r/pid"));
  ASSERT_EQ(kill(worker, 0), 0);
  kill(server, SIGKILL);
  waitpid(server, nullptr, 0);
  const auto is_gone = [&] {
    std::ifstream status("/proc/" + std::to_string(worker) + "/status");
    std::string line;
    while (std::getline(status, line)) {
      if (line.starts_with("State:")) return line.find('Z') != std::string::npos;
    }
    return true;
  };
  const auto until = std::chrono::steady_clock::now() + 5s;
  while (!is_gone() && std::chrono::steady_clock::now() < until) std::this_thread::sleep_for(10ms);
  EXPECT_TRUE(is_gone());
}

}  // namespace
}  // namespace leda::server
