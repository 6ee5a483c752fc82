// The suite of executors over a real Slurm, and what only a cluster promises.

#include "server/jobs/executors/slurm/slurm_executor.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <set>
#include <thread>

#include "server/jobs/executors/spawn.hpp"
#include "tests/cluster/one_node_slurm.hpp"
#include "tests/server/jobs/executors/executor_suite.hpp"

namespace leda::server {
namespace {

using namespace std::chrono_literals;
using tests::ExecutorKind;
using tests::ExecutorSuite;
using tests::OneNodeSlurm;

SlurmSettings quick_settings() {
  SlurmSettings settings;
  settings.program = LEDA_PROGRAM;
  settings.look_every = 200ms;
  settings.gather = 100ms;
  settings.settle = 1s;
  settings.patience = 10s;
  settings.max_array_size = 5;
  return settings;
}

RunLimits small(RunLimits limits = {}) {
  limits.memory_bytes = std::uint64_t{1} << 30;
  return limits;
}

INSTANTIATE_TEST_SUITE_P(Slurm, ExecutorSuite,
                         testing::Values(ExecutorKind{
                             "slurm",
                             [](const auto& program, const auto& limits, const auto& state) {
                               OneNodeSlurm::instance();
                               return std::make_unique<SlurmExecutor>(program, quick_settings(),
                                                                      small(limits), state);
                             },
                             OneNodeSlurm::missing,
                             150s,  // Slurm looks for runs beyond their time every half minute
                             60s}),
                         [](const auto& kind) { return kind.param.name; });

class SlurmExecutorTest : public testing::Test {
 protected:
  void SetUp() override {
    if (const auto missing = OneNodeSlurm::missing(); !missing.empty()) GTEST_SKIP() << missing;
    OneNodeSlurm::instance();
  }

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
  std::unique_ptr<SlurmExecutor> executor(const std::filesystem::path& worker,
                                          const SlurmSettings& settings = quick_settings()) {
    return std::make_unique<SlurmExecutor>(worker, settings, small(), folder.path() / "notes");
  }
  static RunEnd wait_for_end(Executor& of, std::chrono::seconds patience = 60s) {
    const auto until = std::chrono::steady_clock::now() + patience;
    while (std::chrono::steady_clock::now() < until) {
      auto ended = of.poll();
      if (!ended.empty()) return ended.front();
      std::this_thread::sleep_for(10ms);
    }
    return {"none", RunEnd::How::exited, -1, "the run did not end"};
  }
  bool wait_for_file(Executor& of, const std::string& file) {
    const auto until = std::chrono::steady_clock::now() + 60s;
    while (!exists(folder.path() / file) && std::chrono::steady_clock::now() < until) {
      EXPECT_TRUE(of.poll().empty());
      std::this_thread::sleep_for(10ms);
    }
    return exists(folder.path() / file);
  }
  std::size_t notes() const {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "notes")) {
      count += entry.path().extension() == ".json" ? 1 : 0;
    }
    return count;
  }

  tests::TemporaryFolder folder;
};

TEST_F(SlurmExecutorTest, ManyRunsAreFewArraysAndLeaveNoNotes) {
  const auto of = executor(program("exit 0"));
  std::set<std::string> wanted, told;
  for (int i = 0; i < 12; ++i) {
    const std::string run = folder.path().filename().string() + "-" + std::to_string(i);
    of->submit(order(run));
    wanted.insert(run);
  }
  const auto until = std::chrono::steady_clock::now() + 60s;
  std::size_t most_notes = 0;
  while (told.size() < wanted.size() && std::chrono::steady_clock::now() < until) {
    for (const RunEnd& end : of->poll()) told.insert(end.run);
    most_notes = std::max(most_notes, notes());
    std::this_thread::sleep_for(5ms);
  }
  EXPECT_EQ(told, wanted);
  EXPECT_EQ(most_notes, 3U) << "12 runs in arrays of at most 5";
  const auto gone = std::chrono::steady_clock::now() + 5s;
  while (notes() > 0 && std::chrono::steady_clock::now() < gone) std::this_thread::sleep_for(10ms);
  EXPECT_EQ(notes(), 0U);
}

TEST_F(SlurmExecutorTest, AControllerThatIsDownSaysNothingAboutRuns) {
  const auto of = executor(program("touch $4/up; sleep 1; touch $4/done; exit 6"));
  of->submit(order("r"));
  ASSERT_TRUE(wait_for_file(*of, "r/up"));
  OneNodeSlurm::instance().call("stop", "controller");
  of->submit(order("later"));
  ASSERT_TRUE(wait_for_file(*of, "r/done"));
  const auto until = std::chrono::steady_clock::now() + 6s;
  while (std::chrono::steady_clock::now() < until) {
    EXPECT_TRUE(of->poll().empty()) << "nobody could know";
    std::this_thread::sleep_for(50ms);
  }
  OneNodeSlurm::instance().call("start", "controller");
  std::map<std::string, int> codes;
  while (codes.size() < 2) {
    const RunEnd end = wait_for_end(*of);
    ASSERT_NE(end.run, "none");
    codes[end.run] = end.exit_code;
  }
  EXPECT_EQ(codes, (std::map<std::string, int>{{"later", 6}, {"r", 6}}));
}

TEST_F(SlurmExecutorTest, AnArrayWhoseNumberWasNeverLearntIsFoundByItsName) {
  const auto worker = program("echo up >> $4/up; sleep 3; exit 7");
  const RunOrder run = order("r");
  {
    const auto first = executor(worker);
    first->submit(run);
    ASSERT_TRUE(wait_for_file(*first, "r/up"));
  }
  // As if the server had died between Slurm's answer and the note of it.
  const ArrayNotes kept(folder.path() / "notes");
  for (ArrayNote note : kept.read()) {
    EXPECT_FALSE(note.id.empty());
    note.id.clear();
    kept.write(note);
  }
  const auto second = executor(worker);
  EXPECT_TRUE(second->adopt(run));
  EXPECT_EQ(wait_for_end(*second).exit_code, 7);
  std::ifstream up(folder.path() / "r" / "up");
  std::string line;
  int starts = 0;
  while (std::getline(up, line)) ++starts;
  EXPECT_EQ(starts, 1);
}

TEST_F(SlurmExecutorTest, AnArrayThatSlurmNeverGotIsStarted) {
  const RunOrder run = order("r");
  const auto worker = program("exit 8");
  const ArrayNotes kept(folder.path() / "notes");
  kept.write({kept.new_name(), "", worker, small(), {run.folder}});
  const auto of = executor(worker);
  EXPECT_TRUE(of->adopt(run));
  EXPECT_EQ(wait_for_end(*of).exit_code, 8);
}

TEST_F(SlurmExecutorTest, WhatTheControllerForgotStandsInTheFileOfCompletedJobs) {
  const auto worker = program("touch $4/up; exit 9");
  const RunOrder run = order("r");
  std::string name;
  {
    const auto first = executor(worker);
    first->submit(run);
    ASSERT_TRUE(wait_for_file(*first, "r/up"));
    name = ArrayNotes(folder.path() / "notes").read().at(0).name;
  }
  const auto until = std::chrono::steady_clock::now() + 20s;
  while (OneNodeSlurm::instance().completed(name) == 0 &&
         std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(10ms);
  }
  // A number that the controller does not know (any more).
  const ArrayNotes kept(folder.path() / "notes");
  ArrayNote note = kept.read().at(0);
  note.id = "999999";
  kept.write(note);
  SlurmSettings settings = quick_settings();
  settings.completion_file = OneNodeSlurm::instance().completion_file();
  const auto second = executor(worker, settings);
  EXPECT_TRUE(second->adopt(run));
  EXPECT_EQ(wait_for_end(*second).exit_code, 9);
}

TEST_F(SlurmExecutorTest, WhatNobodyKnowsAnyMoreCountsByItsResult) {
  const auto worker = program("exit 0");
  const RunOrder with = order("with"), without = order("without");
  std::ofstream(with.folder / "result.json") << "{}";
  const ArrayNotes kept(folder.path() / "notes");
  kept.write({kept.new_name(), "999999", worker, small(), {with.folder, without.folder}});
  const auto of = executor(worker);
  EXPECT_TRUE(of->adopt(with));
  EXPECT_TRUE(of->adopt(without));
  std::map<std::string, RunEnd::How> ends;
  while (ends.size() < 2) {
    const RunEnd end = wait_for_end(*of);
    ASSERT_NE(end.run, "none");
    ends[end.run] = end.how;
  }
  EXPECT_EQ(ends["with"], RunEnd::How::exited);
  EXPECT_EQ(ends["without"], RunEnd::How::killed);
}

TEST_F(SlurmExecutorTest, ARunThatSomebodyCancelsInTheQueueWasKilled) {
  SlurmSettings settings = quick_settings();
  settings.options = {"--hold"};
  const auto of = executor(program("exit 0"), settings);
  of->submit(order("r"));
  std::vector<ArrayNote> kept;
  const auto until = std::chrono::steady_clock::now() + 60s;
  while ((kept.empty() || kept.front().id.empty()) && std::chrono::steady_clock::now() < until) {
    EXPECT_TRUE(of->poll().empty());
    std::this_thread::sleep_for(50ms);
    kept = ArrayNotes(folder.path() / "notes").read();
  }
  ASSERT_EQ(kept.size(), 1U);
  const std::atomic<bool> never{false};
  ask_program({"scancel", kept.front().id}, 10s, never);
  const RunEnd end = wait_for_end(*of);
  EXPECT_EQ(end.run, "r");
  EXPECT_EQ(end.how, RunEnd::How::killed) << "the dispatcher tries it again";
}

TEST_F(SlurmExecutorTest, WhatSlurmRefusesEndsWithItsWords) {
  SlurmSettings settings = quick_settings();
  settings.partition = "nowhere";
  const auto of = executor(program("exit 0"), settings);
  of->submit(order("r"));
  const RunEnd end = wait_for_end(*of);
  EXPECT_EQ(end.how, RunEnd::How::killed);
  EXPECT_NE(end.reason.find("partition"), std::string::npos) << end.reason;
}

}  // namespace
}  // namespace leda::server
