#include "server/jobs/study_folder.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "server/operate/version.hpp"
#include "tests/server/run_fixture.hpp"
#include "tests/server/temporary_folder.hpp"

namespace leda::server {
namespace {

/// Leaves a result for every run, or none where `fails` names it.
class Worker final : public Executor {
 public:
  std::string fails;
  std::string made_by = version();
  std::vector<std::string> ran;

  std::size_t free_slots() const override { return ended_.empty() ? 1 : 0; }
  void submit(const RunOrder& order) override {
    ran.push_back(order.run);
    if (order.run == fails) {
      tests::write_text(order.folder / "log.txt", "out of memory\n");
      ended_.push_back({order.run, RunEnd::How::killed, 0, "the worker died of signal 9"});
      return;
    }
    auto result = tests::result_of_case_in(order.folder);
    result.version = made_by;
    tests::leave_result(order.folder, result);
    ended_.push_back({order.run, RunEnd::How::exited, 0, ""});
  }
  std::vector<RunEnd> poll() override { return std::exchange(ended_, {}); }
  void cancel(const std::string& /*run*/) override {}

 private:
  std::vector<RunEnd> ended_;
};

class StudyFolder : public testing::Test {
 protected:
  static StudyFile study(int max_time_s = 2) {
    StudyFile asked;
    asked.of = *parse_case_file(tests::small_case()).value;
    asked.of.settings.stop.max_time_s = max_time_s;
    asked.question.settings = {{{1, 4}, 1}, {{2, 4}, 0}};
    return asked;
  }
  StudyRuns run(const StudyFile& asked, const RunsListener& listener = {}) {
    worker.ran.clear();
    return run_study(asked, folder.path(), worker, listener);
  }

  tests::TemporaryFolder folder;
  Worker worker;
};

TEST_F(StudyFolder, RunsEverySettingCoarseFirst) {
  const auto done = run(study());
  EXPECT_EQ(worker.ran,
            (std::vector<std::string>{"cell-2-particles-4-seed-0", "cell-1-particles-4-seed-0",
                                      "cell-1-particles-4-seed-1"}));
  ASSERT_EQ(done.runs.size(), 3U);
  for (const auto& one : done.runs) EXPECT_TRUE(one.result) << one.reason;
  EXPECT_FALSE(done.interrupted);
}

TEST_F(StudyFolder, WhatStandsIsNotRunAgain) {
  run(study());
  const auto again = run(study());
  EXPECT_TRUE(worker.ran.empty());
  EXPECT_TRUE(again.runs[2].result);
}

TEST_F(StudyFolder, MoreTimeStepsFindTheRunsOfTheCasesOwn) {
  run(study());
  StudyFile more = study();
  more.question.settings = {{{1, 4, 0.65}, 1}, {{1, 4, 0.9}, 0}, {{2, 4, 0.65}, 0}};
  const auto done = run(more);
  EXPECT_EQ(worker.ran, std::vector<std::string>{"cell-1-particles-4-step-0.9-seed-0"});
  ASSERT_EQ(done.runs.size(), 4U);
  EXPECT_EQ(done.runs[1].setting.time_step_factor, 0.9);
  EXPECT_NE(done.runs[1].result->case_sha256, done.runs[2].result->case_sha256);
  run(more);
  EXPECT_TRUE(worker.ran.empty());
  // The same steps of a case with another of its own are other names: nothing wrong is taken.
  more.of.settings.time_step_factor = 0.9;
  run(more);
  EXPECT_EQ(worker.ran.size(), 4U);
}

TEST_F(StudyFolder, ResultsOfAnotherCaseOrVersionAreRunAgain) {
  run(study());
  run(study(3));
  EXPECT_EQ(worker.ran.size(), 3U);
  worker.made_by = "0.0.0";
  run(study(4));
  worker.made_by = version();
  run(study(4));
  EXPECT_EQ(worker.ran.size(), 3U);
}

TEST_F(StudyFolder, AFailedRunHasItsReasonAndIsTriedByTheNextCall) {
  worker.fails = "cell-1-particles-4-seed-0";
  const auto done = run(study());
  EXPECT_FALSE(done.runs[1].result);
  EXPECT_EQ(done.runs[1].reason, "the worker died of signal 9: out of memory");
  EXPECT_TRUE(done.runs[2].result);
  worker.fails.clear();
  const auto again = run(study());
  EXPECT_EQ(worker.ran, std::vector<std::string>{"cell-1-particles-4-seed-0"});
  EXPECT_TRUE(again.runs[1].result);
}

TEST_F(StudyFolder, AnInterruptedStudyGoesOnWhereItWas) {
  int asked_times = 0;
  const auto cut = run(study(), {{}, [&] { return ++asked_times > 1; }});
  EXPECT_TRUE(cut.interrupted);
  EXPECT_EQ(worker.ran.size(), 1U);
  EXPECT_EQ(cut.runs[2].reason, "interrupted");
  const auto rest = run(study());
  EXPECT_EQ(worker.ran.size(), 2U);
  EXPECT_TRUE(rest.runs[0].result);
}

}  // namespace
}  // namespace leda::server
