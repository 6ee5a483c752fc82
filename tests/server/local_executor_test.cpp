#include "server/local_executor.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <thread>

#include "tests/server/temporary_folder.hpp"

namespace leda::server {
namespace {

using namespace std::chrono_literals;

/// A program that is called as a worker is: simulate CASE --out FOLDER.
class LocalExecutorTest : public testing::Test {
 protected:
  std::filesystem::path program(const std::string& body) {
    const auto file = folder.path() / "worker.sh";
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

TEST_F(LocalExecutorTest, CallsTheProgramWithoutAShellAndKeepsItsOutput) {
  LocalExecutor executor(program("echo \"$# $1 $3\"; echo \"$2\" >&2"), 2);
  executor.submit(order("a b;$(touch x)'"));
  EXPECT_EQ(executor.free_slots(), 1U);
  const RunEnd end = wait_for_end(executor);
  EXPECT_EQ(end.how, RunEnd::How::exited);
  EXPECT_EQ(end.exit_code, 0);
  EXPECT_EQ(executor.free_slots(), 2U);
  const std::string log = text("a b;$(touch x)'/log.txt");
  EXPECT_NE(log.find("4 simulate --out"), std::string::npos) << log;
  EXPECT_NE(log.find("a b;$(touch x)'/case.json"), std::string::npos) << log;
}

TEST_F(LocalExecutorTest, TellsTheExitCode) {
  LocalExecutor executor(program("exit 3"), 1);
  executor.submit(order("r"));
  const RunEnd end = wait_for_end(executor);
  EXPECT_EQ(end.run, "r");
  EXPECT_EQ(end.exit_code, 3);
  EXPECT_FALSE(end.reason.empty());
}

TEST_F(LocalExecutorTest, TellsTheSignalAWorkerDiedOf) {
  LocalExecutor executor(program("kill -9 $$"), 1);
  executor.submit(order("r"));
  const RunEnd end = wait_for_end(executor);
  EXPECT_EQ(end.how, RunEnd::How::killed);
  EXPECT_NE(end.reason.find("signal 9"), std::string::npos) << end.reason;
}

TEST_F(LocalExecutorTest, AProgramThatIsNotThereEndsTheRun) {
  LocalExecutor executor(folder.path() / "nothing", 1);
  executor.submit(order("r"));
  EXPECT_EQ(wait_for_end(executor).exit_code, 127);
  EXPECT_NE(text("r/log.txt").find("could not be started"), std::string::npos);
}

TEST_F(LocalExecutorTest, AFolderThatIsNotThereEndsTheRun) {
  LocalExecutor executor(program("exit 0"), 1);
  executor.submit({"r", folder.path() / "nothing"});
  EXPECT_EQ(wait_for_end(executor).how, RunEnd::How::killed);
}

TEST_F(LocalExecutorTest, CancelsEvenAWorkerThatDoesNotListen) {
  LocalExecutor executor(program("trap '' TERM; echo up; while :; do sleep 0.1; done"), 1);
  executor.submit(order("r"));
  while (text("r/log.txt").empty()) std::this_thread::sleep_for(10ms);
  executor.cancel("r");
  executor.cancel("unknown");
  EXPECT_EQ(wait_for_end(executor).how, RunEnd::How::cancelled);
}

TEST_F(LocalExecutorTest, EndsARunThatTakesTooLong) {
  RunLimits limits;
  limits.wall = 1s;
  LocalExecutor executor(program("exec sleep 60"), 1, limits);
  executor.submit(order("r"));
  EXPECT_EQ(wait_for_end(executor).how, RunEnd::How::over_limit);
}

TEST_F(LocalExecutorTest, EndsARunThatUsesTooMuchProcessorTime) {
  RunLimits limits;
  limits.cpu_s = 1;
  LocalExecutor executor(program("while :; do :; done"), 1, limits);
  executor.submit(order("r"));
  EXPECT_EQ(wait_for_end(executor).how, RunEnd::How::over_limit);
}

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
