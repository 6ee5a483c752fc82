// Jobs beside one another: their turns, and their dismissal.

#include <gtest/gtest.h>

#include <future>
#include <string>
#include <vector>

#include "tests/server/jobs/scripted_dispatcher.hpp"

namespace leda::server {
namespace {

using namespace std::chrono_literals;
using db::JobState;
using db::SectionState;

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
