// What a dispatcher finds of an earlier one.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/server/jobs/scripted_dispatcher.hpp"

namespace leda::server {
namespace {

using db::JobState;
using db::SectionState;

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

}  // namespace
}  // namespace leda::server
