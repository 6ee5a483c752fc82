#include "tests/server/jobs/executors/executor_suite.hpp"

#include <fstream>
#include <map>
#include <sstream>
#include <thread>

namespace leda::tests {

using namespace std::chrono_literals;
using server::Executor;
using server::RunEnd;
using server::RunOrder;

void ExecutorSuite::SetUp() {
  if (const auto missing = GetParam().missing(); !missing.empty()) GTEST_SKIP() << missing;
}

std::filesystem::path ExecutorSuite::program(const std::string& body) {
  auto file = folder.path() / "worker.sh";
  std::ofstream(file) << "#!/bin/sh\n" << body << "\n";
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  return file;
}

RunOrder ExecutorSuite::order(const std::string& run) {
  std::filesystem::create_directory(folder.path() / run);
  return {run, folder.path() / run};
}

std::unique_ptr<Executor> ExecutorSuite::executor(const std::filesystem::path& worker,
                                                  const server::RunLimits& limits) {
  const auto state = folder.path() / "state";
  std::filesystem::create_directory(state);
  return GetParam().make(worker, limits, state);
}

RunEnd ExecutorSuite::wait_for_end(Executor& of) {
  const auto until = std::chrono::steady_clock::now() + GetParam().patience;
  while (std::chrono::steady_clock::now() < until) {
    auto ended = of.poll();
    if (!ended.empty()) return ended.front();
    std::this_thread::sleep_for(10ms);
  }
  return {"none", RunEnd::How::exited, -1, "the run did not end"};
}

std::string ExecutorSuite::text(const std::filesystem::path& file) const {
  std::ifstream in(folder.path() / file);
  std::stringstream all;
  all << in.rdbuf();
  return all.str();
}

bool ExecutorSuite::wait_for_text(Executor& of, const std::filesystem::path& file) {
  const auto until = std::chrono::steady_clock::now() + GetParam().patience;
  while (text(file).empty() && std::chrono::steady_clock::now() < until) {
    EXPECT_TRUE(of.poll().empty()) << "it ended before it said anything";
    std::this_thread::sleep_for(10ms);
  }
  return !text(file).empty();
}

namespace {

constexpr const char* listens = "echo up; exec sleep 60";
constexpr const char* does_not_listen = "trap '' TERM; echo up; while :; do sleep 0.1; done";

TEST_P(ExecutorSuite, CallsTheProgramWithoutAShellAndKeepsItsOutput) {
  const auto of = executor(program("echo \"$# $1 $3\"; echo \"$2\" >&2"));
  of->submit(order("a b;$(touch x)'"));
  const RunEnd end = wait_for_end(*of);
  EXPECT_EQ(end.run, "a b;$(touch x)'");
  EXPECT_EQ(end.how, RunEnd::How::exited);
  EXPECT_EQ(end.exit_code, 0);
  EXPECT_EQ(end.reason, "");
  const std::string log = text("a b;$(touch x)'/log.txt");
  EXPECT_NE(log.find("6 simulate --out"), std::string::npos) << log;
  EXPECT_NE(log.find("a b;$(touch x)'/case.json"), std::string::npos) << log;
}

TEST_P(ExecutorSuite, TellsTheExitCode) {
  const auto of = executor(program("exit 3"));
  of->submit(order("r"));
  const RunEnd end = wait_for_end(*of);
  EXPECT_EQ(end.run, "r");
  EXPECT_EQ(end.how, RunEnd::How::exited);
  EXPECT_EQ(end.exit_code, 3);
  EXPECT_FALSE(end.reason.empty());
}

TEST_P(ExecutorSuite, TellsTheSignalAWorkerDiedOf) {
  const auto of = executor(program("kill -9 $$"));
  of->submit(order("r"));
  const RunEnd end = wait_for_end(*of);
  EXPECT_EQ(end.how, RunEnd::How::killed);
  EXPECT_NE(end.reason.find("signal 9"), std::string::npos) << end.reason;
}

TEST_P(ExecutorSuite, AProgramThatIsNotThereEndsTheRun) {
  const auto of = executor(folder.path() / "nothing");
  of->submit(order("r"));
  EXPECT_EQ(wait_for_end(*of).exit_code, 127);
  EXPECT_NE(text("r/log.txt").find("could not be started"), std::string::npos);
}

TEST_P(ExecutorSuite, AFolderThatIsNotThereEndsTheRun) {
  const auto of = executor(program("exit 0"));
  of->submit({"r", folder.path() / "not" / "there"});
  const RunEnd end = wait_for_end(*of);
  EXPECT_EQ(end.run, "r");
  EXPECT_FALSE(end.reason.empty());
}

TEST_P(ExecutorSuite, EndsARunThatUsesTooMuchProcessorTime) {
  server::RunLimits limits;
  limits.cpu_s = 1;
  const auto of = executor(program("while :; do :; done"), limits);
  of->submit(order("r"));
  EXPECT_EQ(wait_for_end(*of).how, RunEnd::How::over_limit);
}

TEST_P(ExecutorSuite, TimeThatWasOverBeforeARunBeganIsNoFaultOfTheRun) {
  server::RunLimits limits;
  limits.wall = GetParam().shortest_wall;
  const auto of =
      executor(program("[ -e $4/begins ] && echo {} > $4/progress.json; exec sleep 600"), limits);
  std::ofstream(order("begun").folder / "begins") << "yes";
  of->submit({"begun", folder.path() / "begun"});
  of->submit(order("not begun"));
  std::map<std::string, RunEnd> told;
  const auto until = std::chrono::steady_clock::now() + GetParam().patience;
  while (told.size() < 2 && std::chrono::steady_clock::now() < until) {
    for (const RunEnd& end : of->poll()) told[end.run] = end;
    std::this_thread::sleep_for(10ms);
  }
  EXPECT_EQ(told["begun"].how, RunEnd::How::over_limit);
  EXPECT_EQ(told["not begun"].how, RunEnd::How::killed);
  EXPECT_NE(told["not begun"].reason.find("before the run had begun"), std::string::npos);
}

TEST_P(ExecutorSuite, TellsEachEndOnce) {
  const auto of = executor(program("exit $(cat $4/code)"));
  std::map<std::string, int> wanted;
  for (int i = 0; i < 12; ++i) {
    const RunOrder run = order("r" + std::to_string(i));
    std::ofstream(run.folder / "code") << i;
    of->submit(run);
    wanted[run.run] = i;
  }
  std::map<std::string, int> told;
  const auto until = std::chrono::steady_clock::now() + 3 * GetParam().patience;
  while (told.size() < wanted.size() && std::chrono::steady_clock::now() < until) {
    for (const RunEnd& end : of->poll()) {
      EXPECT_TRUE(told.emplace(end.run, end.exit_code).second) << end.run << " was told twice";
    }
    std::this_thread::sleep_for(10ms);
  }
  EXPECT_EQ(told, wanted);
  EXPECT_TRUE(of->poll().empty());
}

TEST_P(ExecutorSuite, ARunTakesASlotUntilItsEndIsTold) {
  const auto of = executor(program("exit 0"));
  const auto free = of->free_slots();
  of->submit(order("r"));
  EXPECT_EQ(of->free_slots(), free - 1);
  wait_for_end(*of);
  EXPECT_EQ(of->free_slots(), free);
}

TEST_P(ExecutorSuite, CancelsEvenAWorkerThatDoesNotListen) {
  for (const char* body : {listens, does_not_listen}) {
    const auto of = executor(program(body));
    const std::string run = body == listens ? "listens" : "deaf";
    of->submit(order(run));
    ASSERT_TRUE(wait_for_text(*of, run + "/log.txt"));
    of->cancel(run);
    of->cancel("unknown");
    const RunEnd end = wait_for_end(*of);
    EXPECT_EQ(end.run, run);
    EXPECT_EQ(end.how, RunEnd::How::cancelled);
  }
}

TEST_P(ExecutorSuite, CancelsARunThatHasNotStarted) {
  const auto of = executor(program(listens));
  of->submit(order("r"));
  of->cancel("r");
  EXPECT_EQ(wait_for_end(*of).how, RunEnd::How::cancelled);
}

TEST_P(ExecutorSuite, ARunOutlivesTheServerOrDiesWithIt) {
  const auto worker = program("echo up; sleep 2; exit 5");
  const RunOrder run = order("r");
  bool outlives = false;
  {
    const auto first = executor(worker);
    outlives = first->outlives_server();
    first->submit(run);
    ASSERT_TRUE(wait_for_text(*first, "r/log.txt"));
  }
  const auto second = executor(worker);
  EXPECT_EQ(second->adopt(run), outlives);
  EXPECT_EQ(second->adopt(run), outlives) << "it may be asked again";
  EXPECT_FALSE(second->adopt(order("unknown")));
  if (outlives) {
    const RunEnd end = wait_for_end(*second);
    EXPECT_EQ(end.run, "r");
    EXPECT_EQ(end.exit_code, 5);
  }
  EXPECT_TRUE(second->poll().empty());
}

TEST_P(ExecutorSuite, ARunThatNobodyAdoptsIsGivenUp) {
  const auto worker = program("echo up; trap 'echo ended; exit 1' TERM; sleep 60 & wait");
  {
    const auto first = executor(worker);
    if (!first->outlives_server()) GTEST_SKIP() << "its runs die with the server";
    first->submit(order("r"));
    ASSERT_TRUE(wait_for_text(*first, "r/log.txt"));
  }
  const auto second = executor(worker);
  const auto until = std::chrono::steady_clock::now() + GetParam().patience;
  while (text("r/log.txt") == "up\n" && std::chrono::steady_clock::now() < until) {
    EXPECT_TRUE(second->poll().empty());
    std::this_thread::sleep_for(10ms);
  }
  EXPECT_EQ(text("r/log.txt"), "up\nended\n");
}

}  // namespace
}  // namespace leda::tests
