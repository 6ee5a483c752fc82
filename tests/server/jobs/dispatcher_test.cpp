#include "server/jobs/dispatcher.hpp"

#include <gtest/gtest.h>

#include <future>
#include <set>
#include <thread>

#include "tests/server/held_store.hpp"
#include "tests/server/jobs/scripted_dispatcher.hpp"

namespace leda::server {
namespace {

using namespace std::chrono_literals;
using db::JobState;
using db::SectionState;

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

}  // namespace
}  // namespace leda::server
