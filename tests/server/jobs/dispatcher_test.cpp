#include "server/jobs/dispatcher.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <set>
#include <thread>
#include <utility>

#include "tests/server/held_store.hpp"
#include "tests/server/run_fixture.hpp"
#include "tests/server/temporary_folder.hpp"

namespace leda::server {
namespace {

using namespace std::chrono_literals;
using db::JobState;
using db::SectionState;

/// Ends every run at once, as it is told to; keeps those it is told to keep.
class ScriptedExecutor final : public Executor {
 public:
  using Script = std::function<std::optional<RunEnd>(const RunOrder&)>;
  /// @param cluster its runs outlive it, and are adopted
  explicit ScriptedExecutor(Script script, bool cluster = false)
      : script_(std::move(script)), cluster_(cluster) {}

  std::size_t free_slots() const override { return 2 - std::min<std::size_t>(2, kept_.size()); }
  void submit(const RunOrder& order) override {
    if (auto end = script_(order)) {
      ended_.push_back(*end);
    } else {
      kept_.push_back(order.run);
    }
  }
  std::vector<RunEnd> poll() override { return std::exchange(ended_, {}); }
  void cancel(const std::string& run) override {
    if (std::erase(kept_, run) > 0) ended_.push_back({run, RunEnd::How::cancelled, 0, "cancelled"});
  }
  bool outlives_server() const override { return cluster_; }
  bool adopt(const RunOrder& order) override {
    if (cluster_) submit(order);
    return cluster_;
  }

 private:
  Script script_;
  bool cluster_;
  std::vector<RunEnd> ended_;
  std::vector<std::string> kept_;
};

RunEnd exited(const RunOrder& order, int code) {
  return {order.run, RunEnd::How::exited, code, ""};
}
RunEnd killed(const RunOrder& order) {
  return {order.run, RunEnd::How::killed, 0, "the worker died of signal 9"};
}

class DispatcherTest : public testing::Test {
 protected:
  /// One section, as simulate-section asks for it.
  std::string add_job(const std::string& id = "job") {
    db::JobRecord job;
    job.id = id;
    job.process = "simulate-section";
    job.request = tests::simulate_request();
    store.add_job(job);
    return id;
  }

  std::unique_ptr<Dispatcher> dispatcher(const ScriptedExecutor::Script& script,
                                         bool cluster = false) {
    auto made = std::make_unique<Dispatcher>(data, store, [script, cluster, this] {
      const auto counted = [script, this](const RunOrder& order) {
        ++submitted;
        return script(order);
      };
      return std::make_unique<ScriptedExecutor>(counted, cluster);
    });
    made->start();
    return made;
  }

  db::JobRecord wait_for_end(const std::string& id = "job") {
    return wait([&](const db::JobRecord& job) { return !job.finished.empty(); }, id);
  }

  db::JobRecord wait(const std::function<bool(const db::JobRecord&)>& until,
                     const std::string& id = "job") {
    const auto end = std::chrono::steady_clock::now() + 20s;
    for (;;) {
      auto job = store.job(id).value();
      if (until(job) || std::chrono::steady_clock::now() > end) return job;
      std::this_thread::sleep_for(5ms);
    }
  }

  db::SectionRecord section(const std::string& job = "job") { return store.sections(job).at(0); }

  tests::TemporaryFolder folder;
  DataFolder data{folder.path()};
  db::Store store{data.store(), std::chrono::milliseconds(50)};
  std::atomic<int> submitted{0};
};

std::optional<RunEnd> with_result(const RunOrder& order) {
  tests::leave_result(order.folder, tests::result_of_case_in(order.folder));
  return exited(order, 0);
}

TEST_F(DispatcherTest, AResultIsTakenInAndTheJobSucceeds) {
  add_job();
  const auto running = dispatcher(with_result);
  const auto job = wait_for_end();
  EXPECT_EQ(job.state, JobState::successful) << job.message;
  EXPECT_EQ(job.progress, 100);
  EXPECT_EQ(section().state, SectionState::finished);
  ASSERT_TRUE(section().result);
  EXPECT_DOUBLE_EQ(section().result->crest_to_crest_retrogression_m, 12.5);
  EXPECT_EQ(submitted, 1);
}

TEST_F(DispatcherTest, AWorkerThatDiesIsTriedAgainInAFolderOfItsOwn) {
  add_job();
  std::set<std::filesystem::path> folders;
  const auto running = dispatcher([&](const RunOrder& order) {
    folders.insert(order.folder);
    return folders.size() < 3 ? std::optional(killed(order)) : with_result(order);
  });
  EXPECT_EQ(wait_for_end().state, JobState::successful);
  EXPECT_EQ(folders.size(), 3U);
  EXPECT_EQ(section().attempts, 3);
}

TEST_F(DispatcherTest, AfterThreeTriesTheSectionFailsWithItsReason) {
  add_job();
  const auto running = dispatcher([&](const RunOrder& order) {
    tests::write_text(order.folder / "log.txt", "out of memory\n");
    return killed(order);
  });
  const auto job = wait_for_end();
  EXPECT_EQ(job.state, JobState::failed);
  EXPECT_EQ(submitted, 3);
  EXPECT_EQ(section().state, SectionState::failed);
  EXPECT_EQ(section().reason, "the worker died of signal 9: out of memory");
}

TEST_F(DispatcherTest, ARunThatNeverBeganIsTriedAgainAndKeepsItsCheckpoint) {
  add_job();
  std::vector<std::string> checkpoints;
  const auto running = dispatcher([&](const RunOrder& order) {
    checkpoints.push_back(tests::read_text(order.folder / "checkpoint.bin"));
    if (submitted > 1) return std::optional(out_of_time(order.run, false));
    tests::write_text(order.folder / "checkpoint.bin", "state");
    tests::write_text(order.folder / "frames.bin", "frames");
    return std::optional(killed(order));
  });
  EXPECT_EQ(wait_for_end().state, JobState::failed);
  EXPECT_EQ(checkpoints, (std::vector<std::string>{"", "state", "state"}));
  EXPECT_EQ(section().state, SectionState::failed);
  EXPECT_EQ(section().reason, "its time was over before the run had begun");
}

TEST_F(DispatcherTest, ARunThatTookLongerThanItMayIsNotTriedAgain) {
  add_job();
  const auto running = dispatcher(
      [&](const RunOrder& order) { return std::optional(out_of_time(order.run, true)); });
  EXPECT_EQ(wait_for_end().state, JobState::failed);
  EXPECT_EQ(submitted, 1);
}

TEST_F(DispatcherTest, ATryGoesOnFromTheCheckpointOfTheOneBefore) {
  add_job();
  std::vector<bool> has_checkpoint;
  std::vector<std::filesystem::path> folders;
  const auto running = dispatcher([&](const RunOrder& order) {
    folders.push_back(order.folder);
    has_checkpoint.push_back(std::filesystem::exists(order.folder / "checkpoint.bin"));
    if (folders.size() == 3) return with_result(order);
    tests::write_text(order.folder / "checkpoint.bin", "state");
    tests::write_text(order.folder / "frames.bin", "frames");
    return std::optional(killed(order));
  });
  EXPECT_EQ(wait_for_end().state, JobState::successful);
  EXPECT_EQ(has_checkpoint, (std::vector<bool>{false, true, true}));
  ASSERT_EQ(folders.size(), 3U);
  EXPECT_EQ(tests::read_text(folders[2] / "frames.bin"), "") << "what was taken in needs none";
  for (const auto& of_try : folders) {
    EXPECT_FALSE(std::filesystem::exists(of_try / "checkpoint.bin")) << of_try;
  }
}

TEST_F(DispatcherTest, ARetryGoesOnFromTheCheckpointOfTheLastTry) {
  add_job();
  std::string found;
  const auto running = dispatcher([&](const RunOrder& order) {
    found = tests::read_text(order.folder / "checkpoint.bin");
    if (submitted > Dispatcher::most_tries) return with_result(order);
    tests::write_text(order.folder / "checkpoint.bin", "state " + std::to_string(submitted));
    return std::optional(killed(order));
  });
  EXPECT_EQ(wait_for_end().state, JobState::failed);
  store.set_section_state(section().id, SectionState::waiting, "");
  store.set_job_state("job", JobState::accepted, "retried");
  running->add("job");
  const auto job = wait([](const db::JobRecord& now) { return now.state == JobState::successful; });
  EXPECT_EQ(job.state, JobState::successful);
  EXPECT_EQ(found, "state 3");
}

TEST_F(DispatcherTest, AFullDiskIsNoFailureOfTheRun) {
  add_job();
  const auto running = dispatcher([&](const RunOrder& order) {
    return submitted < 3 ? std::optional(exited(order, 5)) : with_result(order);
  });
  EXPECT_EQ(wait_for_end().state, JobState::successful);
  EXPECT_EQ(submitted, 3);
  EXPECT_EQ(store.runs(section().id).front().reason, "the disk is full");
}

TEST_F(DispatcherTest, TooLittleMemoryIsTheReasonAndIsNotTriedAgain) {
  add_job();
  const auto running = dispatcher([&](const RunOrder& order) {
    tests::write_text(order.folder / "log.txt", "error: the run needs more than 1 GB\n");
    return exited(order, 6);
  });
  EXPECT_EQ(wait_for_end().state, JobState::failed);
  EXPECT_EQ(submitted, 1);
  EXPECT_EQ(section().reason, "memory: error: the run needs more than 1 GB");
}

TEST_F(DispatcherTest, AReasonDoesNotTellWhereTheDataFolderIs) {
  add_job();
  const auto running = dispatcher([&](const RunOrder& order) {
    tests::write_text(order.folder / "log.txt", "cannot read " + order.folder.string() + "/x\n");
    return exited(order, 1);
  });
  EXPECT_EQ(wait_for_end().state, JobState::failed);
  EXPECT_EQ(section().reason.find(folder.path().string()), std::string::npos) << section().reason;
  EXPECT_NE(section().reason.find("cannot read runs/job-0-3/x"), std::string::npos);
}

// A failure of the store must not count as one of the run.
TEST_F(DispatcherTest, WhileAnotherProgramHoldsTheStoreNoTryIsCountedTwice) {
  add_job();
  std::promise<void> first_run, held;
  const auto running = dispatcher([&](const RunOrder& order) {
    if (submitted > 2) return with_result(order);
    if (submitted == 1) {
      first_run.set_value();
      held.get_future().wait();
    }
    return std::optional(killed(order));
  });
  first_run.get_future().wait();
  {
    const tests::HeldStore other_program(data.store());
    held.set_value();
    std::this_thread::sleep_for(4s);
    EXPECT_EQ(section().state, SectionState::running);
  }
  EXPECT_EQ(wait_for_end().state, JobState::successful);
  EXPECT_EQ(submitted, 3);
  EXPECT_EQ(section().attempts, 3);
}

TEST_F(DispatcherTest, AnInvalidCaseIsNotTriedAgain) {
  add_job();
  const auto running = dispatcher([](const RunOrder& order) { return exited(order, 2); });
  EXPECT_EQ(wait_for_end().state, JobState::failed);
  EXPECT_EQ(submitted, 1);
}

TEST_F(DispatcherTest, AnUnstableRunFailsButKeepsItsNumbers) {
  add_job();
  const auto running = dispatcher([](const RunOrder& order) {
    auto result = tests::result_of_case_in(order.folder);
    result.status = RunStatus::unstable;
    result.reason = "the energy audit failed";
    tests::leave_result(order.folder, result);
    return exited(order, 3);
  });
  EXPECT_EQ(wait_for_end().state, JobState::failed);
  EXPECT_EQ(section().state, SectionState::failed);
  EXPECT_EQ(section().reason, "the energy audit failed");
  EXPECT_TRUE(section().result);
  EXPECT_EQ(submitted, 1);
}

TEST_F(DispatcherTest, ExitCodeZeroWithoutAResultIsACrash) {
  add_job();
  const auto running = dispatcher([](const RunOrder& order) { return exited(order, 0); });
  EXPECT_EQ(wait_for_end().state, JobState::failed);
  EXPECT_EQ(section().reason, "the run left no result");
  EXPECT_EQ(submitted, 3);
}

TEST_F(DispatcherTest, ARunThatEndedWhileNobodyWatchedIsTakenInOnce) {
  add_job();
  std::string run;
  {
    const auto first = dispatcher([&](const RunOrder& order) {
      run = order.run;
      return std::nullopt;  // still going when the server dies
    });
    wait([](const db::JobRecord& job) { return job.state == JobState::running; });
  }
  ASSERT_EQ(section().state, SectionState::running);
  tests::leave_result(data.run(run), tests::result_of_case_in(data.run(run)));
  const auto second = dispatcher(with_result);
  EXPECT_EQ(wait_for_end().state, JobState::successful);
  EXPECT_EQ(submitted, 1);
  EXPECT_EQ(section().run, run);
}

TEST_F(DispatcherTest, ARunThatWasCutOffStartsAnewInAnotherFolder) {
  add_job();
  std::string run;
  {
    const auto first = dispatcher([&](const RunOrder& order) {
      run = order.run;
      return std::nullopt;
    });
    wait([](const db::JobRecord& job) { return job.state == JobState::running; });
  }
  const auto second = dispatcher(with_result);
  EXPECT_EQ(wait_for_end().state, JobState::successful);
  EXPECT_NE(section().run, run);
  EXPECT_EQ(section().attempts, 2);
}

TEST_F(DispatcherTest, ARunThatOutlivedTheServerIsAdoptedInItsOwnFolder) {
  add_job();
  {
    const auto first = dispatcher([](const RunOrder&) { return std::nullopt; }, true);
    wait([](const db::JobRecord& job) { return job.state == JobState::running; });
  }
  const std::string run = section().run;
  ASSERT_EQ(section().state, SectionState::running);
  const auto second = dispatcher(with_result, true);
  EXPECT_EQ(wait_for_end().state, JobState::successful);
  EXPECT_EQ(section().run, run);
  EXPECT_EQ(section().attempts, 1);
}

TEST_F(DispatcherTest, AFolderLeftByATryThatWasNeverStoredIsNotUsed) {
  add_job();
  tests::write_text(data.runs() / "x", "");
  std::filesystem::create_directory(data.run("job-0-1"));
  tests::write_text(data.run("job-0-1") / "result.json", "left over");
  const auto running = dispatcher(with_result);
  EXPECT_EQ(wait_for_end().state, JobState::successful);
  EXPECT_EQ(section().run, "job-0-2");
}

TEST_F(DispatcherTest, ADismissedJobEndsItsRuns) {
  add_job();
  const auto running = dispatcher([](const RunOrder&) { return std::nullopt; });
  wait([](const db::JobRecord& job) { return job.state == JobState::running; });
  running->dismiss("job");
  EXPECT_EQ(store.job("job")->state, JobState::dismissed);
  EXPECT_EQ(section().state, SectionState::dismissed);
  wait([&](const db::JobRecord&) { return running->running() == 0; });
  EXPECT_EQ(running->running(), 0U);
}

TEST_F(DispatcherTest, ADismissalDoesNotWaitForWhatTheDispatcherDoes) {
  add_job();
  std::promise<void> starting, go_on;
  const auto running = dispatcher([&](const RunOrder&) {
    starting.set_value();
    go_on.get_future().wait();
    return std::nullopt;
  });
  starting.get_future().wait();
  auto dismissal = std::async([&] { running->dismiss("job"); });
  EXPECT_EQ(dismissal.wait_for(10s), std::future_status::ready);
  EXPECT_EQ(section().state, SectionState::dismissed);
  go_on.set_value();
  wait([&](const db::JobRecord&) { return running->running() == 0; });
  EXPECT_EQ(running->running(), 0U);
  EXPECT_EQ(store.runs(section().id).front().outcome, "dismissed");
}

TEST_F(DispatcherTest, WhatIsDismissedBeforeItsTurnIsNotStarted) {
  for (const std::string id : {"first", "second", "third"}) add_job(id);
  std::promise<void> starting, go_on;
  const auto running = dispatcher([&](const RunOrder&) {
    if (submitted == 1) {
      starting.set_value();
      go_on.get_future().wait();
    }
    return std::nullopt;
  });
  starting.get_future().wait();
  store.dismiss_job("second");  // as a handler does it before it tells the dispatcher
  go_on.set_value();
  wait([](const db::JobRecord& job) { return job.state == JobState::running; }, "third");
  EXPECT_EQ(submitted, 2);
  EXPECT_EQ(section("second").state, SectionState::dismissed);
  EXPECT_EQ(section("second").attempts, 0);
  EXPECT_FALSE(std::filesystem::exists(data.run("second-0-1")));
}

TEST_F(DispatcherTest, SmallJobsDoNotWaitForLargeOnes) {
  add_job("first");
  add_job("second");
  std::vector<std::string> order_of_runs;
  const auto running = dispatcher([&](const RunOrder& order) {
    order_of_runs.push_back(order.run);
    return std::nullopt;
  });
  wait([](const db::JobRecord& job) { return job.state == JobState::running; }, "second");
  EXPECT_EQ(order_of_runs, (std::vector<std::string>{"first-0-1", "second-0-1"}));
}

TEST_F(DispatcherTest, AJobThatIsNotUnderstoodFails) {
  db::JobRecord job;
  job.id = "job";
  job.process = "map-region";
  job.request = "{}";
  store.add_job(job);
  const auto running = dispatcher(with_result);
  EXPECT_EQ(wait_for_end().state, JobState::failed);
  EXPECT_EQ(submitted, 0);
}

}  // namespace
}  // namespace leda::server
