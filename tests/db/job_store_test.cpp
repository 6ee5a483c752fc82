#include <gtest/gtest.h>

#include <regex>

#include "db/store.hpp"
#include "tests/db/samples.hpp"

namespace leda::db {
namespace {

using samples::job;
using samples::ScratchFolder;

class JobStore : public ::testing::Test {
 protected:
  std::vector<std::string> ids(const JobFilter& filter) {
    std::vector<std::string> found;
    for (const JobStatus& record : store.jobs(filter)) found.push_back(record.id);
    return found;
  }
  ScratchFolder folder;
  Store store{folder / "leda.sqlite"};
};

TEST_F(JobStore, AJobComesBackWhole) {
  JobRecord j = job();
  j.message = "l'événement";
  j.progress = 7;
  j.idempotency_key = "key-1";
  j.created = j.updated = "2026-01-31T12:00:00.000Z";
  store.add_job(j);
  const auto back = store.job("job-1");
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->process, j.process);
  EXPECT_EQ(back->name, j.name);
  EXPECT_EQ(back->state, JobState::accepted);
  EXPECT_EQ(back->message, j.message);
  EXPECT_EQ(back->progress, 7);
  EXPECT_EQ(back->request, j.request);
  EXPECT_EQ(back->idempotency_key, "key-1");
  EXPECT_EQ(back->created, j.created);
  EXPECT_EQ(back->updated, j.updated);
  EXPECT_EQ(back->started, "");
  EXPECT_EQ(back->finished, "");
  EXPECT_EQ(back->raster, "");
  EXPECT_FALSE(store.job("job-2").has_value());
}

template <class Job>
constexpr bool has_request = requires(Job job) {
  job.request;
};

TEST_F(JobStore, AListOfJobsReadsNoRequest) {
  store.add_job(job());
  const auto status = store.job_status("job-1");
  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->name, job().name);
  EXPECT_EQ(status->sequence, store.job("job-1")->sequence);
  EXPECT_FALSE(store.job_status("job-2").has_value());
  static_assert(has_request<JobRecord>);
  static_assert(!has_request<decltype(status)::value_type>);
  static_assert(!has_request<decltype(store.jobs({}))::value_type>);
  static_assert(!has_request<decltype(store.unfinished_jobs())::value_type>);
}

TEST_F(JobStore, TimesAreGivenWhereTheyAreMissing) {
  store.add_job(job());
  const std::regex iso(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z)");
  EXPECT_TRUE(std::regex_match(store.job("job-1")->created, iso));
  EXPECT_TRUE(std::regex_match(store.job("job-1")->updated, iso));
}

TEST_F(JobStore, AnIdempotencyKeyStandsOnceAndNoneStandsOften) {
  JobRecord first = job("job-1");
  first.idempotency_key = "key";
  store.add_job(first);
  JobRecord second = job("job-2");
  second.idempotency_key = "key";
  EXPECT_THROW(store.add_job(second), StoreConflict);
  EXPECT_EQ(store.job_by_idempotency_key("key")->id, "job-1");
  EXPECT_FALSE(store.job("job-2").has_value());

  store.add_job(job("job-3"));
  store.add_job(job("job-4"));
  EXPECT_FALSE(store.job_by_idempotency_key("").has_value());
  EXPECT_THROW(store.add_job(job("job-4")), StoreConflict);
}

TEST_F(JobStore, ARasterThatDoesNotStandIsRefused) {
  JobRecord j = job();
  j.raster = "dem-unknown";
  EXPECT_THROW(store.add_job(j), StoreError);
  EXPECT_FALSE(store.job("job-1").has_value());
}

TEST_F(JobStore, FiltersAndPages) {
  const char* const days[] = {"2026-01-01", "2026-01-02", "2026-01-03"};
  for (int i = 0; i < 3; ++i) {
    JobRecord j = job(samples::numbered("job-", i));
    j.created = std::string(days[i]) + "T12:00:00.500Z";
    if (i == 1) j.process = "simulate-section";
    if (i == 2) j.state = JobState::failed;
    store.add_job(j);
  }
  using Ids = std::vector<std::string>;
  EXPECT_EQ(ids({}), (Ids{"job-2", "job-1", "job-0"}));
  EXPECT_EQ(ids({.processes = {"map-region"}}), (Ids{"job-2", "job-0"}));
  EXPECT_EQ(ids({.processes = {"map-region", "simulate-section"}}),
            (Ids{"job-2", "job-1", "job-0"}));
  EXPECT_EQ(ids({.states = {JobState::failed, JobState::running}}), (Ids{"job-2"}));
  EXPECT_EQ(ids({.created_from = "2026-01-02T12:00:00Z"}), (Ids{"job-2", "job-1"}));
  EXPECT_EQ(ids({.created_from = "2026-01-02T12:00:01Z"}), (Ids{"job-2"}));
  EXPECT_EQ(ids({.created_to = "2026-01-02T12:00:00Z"}), (Ids{"job-0"}))
      << "half a second after noon is after noon";
  EXPECT_EQ(ids({.created_from = "2026-01-02", .created_to = "2026-01-03"}), (Ids{"job-1"}));
  EXPECT_EQ(ids({.limit = 1, .before = store.job("job-2")->sequence}), (Ids{"job-1"}));
  EXPECT_EQ(ids({.before = store.job("job-0")->sequence}), Ids{});
  EXPECT_EQ(ids({.limit = 0}), Ids{});
  EXPECT_EQ(ids({.limit = -1}), Ids{}) << "SQLite takes a negative limit for none";
  EXPECT_EQ(store.count_jobs({.processes = {"map-region"}, .limit = 1}), 2);
  EXPECT_EQ(store.count_jobs({.processes = {"' OR 1=1 --"}}), 0);
}

TEST_F(JobStore, StatesCarryTheirTimes) {
  store.add_job(job());
  EXPECT_TRUE(store.set_job_state("job-1", JobState::running, "1 of 2"));
  const auto running = store.job("job-1");
  EXPECT_EQ(running->state, JobState::running);
  EXPECT_EQ(running->message, "1 of 2");
  EXPECT_NE(running->started, "");
  EXPECT_EQ(running->finished, "");

  store.set_job_progress("job-1", 40, "half way");
  EXPECT_EQ(store.job("job-1")->progress, 40);
  store.set_job_progress("job-1", 140, "");
  EXPECT_EQ(store.job("job-1")->progress, 100);

  store.set_job_state("job-1", JobState::successful, "done");
  const auto done = store.job("job-1");
  EXPECT_EQ(done->started, running->started);
  EXPECT_NE(done->finished, "");
  EXPECT_EQ(done->progress, 100);
  store.set_job_progress("job-1", 3, "late");
  EXPECT_EQ(store.job("job-1")->progress, 100);
  EXPECT_EQ(store.job("job-1")->message, "done");
}

TEST_F(JobStore, ADismissedJobStaysSoUntilItIsAcceptedAgain) {
  store.add_job(job());
  EXPECT_TRUE(store.set_job_state("job-1", JobState::dismissed, "by the user"));
  EXPECT_FALSE(store.set_job_state("job-1", JobState::running, "late"));
  EXPECT_FALSE(store.set_job_state("job-1", JobState::successful, "late"));
  EXPECT_EQ(store.job("job-1")->state, JobState::dismissed);
  EXPECT_EQ(store.job("job-1")->message, "by the user");
  EXPECT_TRUE(store.set_job_state("job-1", JobState::accepted, "again"));
  EXPECT_EQ(store.job("job-1")->finished, "");
}

// Sections that wait, run, failed and are finished.
void with_sections(Store& store) {
  store.add_job(job());
  std::vector<SectionRecord> sections;
  for (const char* name : {"waits", "runs", "failed", "finished"}) {
    sections.push_back(samples::section(name, static_cast<int>(sections.size())));
  }
  store.set_sections("job-1", sections);
  const auto id = [&](const char* name) { return store.section("job-1", name)->id; };
  store.start_run(id("runs"), "run-1");
  store.start_run(id("failed"), "run-2");
  store.set_section_state(id("failed"), SectionState::failed, "exit code 2");
  store.start_run(id("finished"), "run-3");
  store.take_in(id("finished"), "run-3", samples::result(), samples::placed(sections.back()), "{}");
}

TEST_F(JobStore, DismissingTakesAllThatIsNotDone) {
  with_sections(store);
  store.dismiss_job("job-1");
  EXPECT_EQ(store.job("job-1")->state, JobState::dismissed);
  const auto state = [&](const char* name) { return store.section("job-1", name)->state; };
  EXPECT_EQ(state("waits"), SectionState::dismissed);
  EXPECT_EQ(state("runs"), SectionState::dismissed);
  EXPECT_EQ(state("failed"), SectionState::failed);
  EXPECT_EQ(state("finished"), SectionState::finished);
  const auto tries = store.runs(store.section("job-1", "runs")->id);
  ASSERT_EQ(tries.size(), 1U);
  EXPECT_EQ(tries[0].outcome, "dismissed");
  EXPECT_NE(tries[0].finished, "");
  EXPECT_THROW(store.dismiss_job("nobody"), StoreError);
}

TEST_F(JobStore, ARetryTakesWhatFailed) {
  with_sections(store);
  store.set_job_state("job-1", JobState::failed, "some failed");
  EXPECT_EQ(store.retry_job("job-1"), 2);
  EXPECT_EQ(store.job("job-1")->state, JobState::accepted);
  EXPECT_EQ(store.section("job-1", "failed")->state, SectionState::waiting);
  EXPECT_EQ(store.section("job-1", "finished")->state, SectionState::finished);
  EXPECT_EQ(store.runs(store.section("job-1", "failed")->id)[0].outcome, "failed");
}

TEST_F(JobStore, ARetryOfWhatDidNotFailChangesNothing) {
  store.add_job(job());
  store.set_job_state("job-1", JobState::successful, "done");
  EXPECT_EQ(store.retry_job("job-1"), 0);
  EXPECT_EQ(store.job("job-1")->state, JobState::successful);
}

TEST_F(JobStore, AJobThatDoesNotStandIsAnError) {
  EXPECT_THROW(store.set_job_state("nobody", JobState::running, ""), StoreError);
}

TEST_F(JobStore, UnfinishedJobsComeOldestFirst) {
  for (const JobState state : {JobState::running, JobState::failed, JobState::accepted,
                               JobState::successful, JobState::dismissed}) {
    JobRecord j = job(std::string("job-") + to_string(state));
    j.state = state;
    store.add_job(j);
  }
  const auto unfinished = store.unfinished_jobs();
  ASSERT_EQ(unfinished.size(), 2U);
  EXPECT_EQ(unfinished[0].id, "job-running");
  EXPECT_EQ(unfinished[1].id, "job-accepted");
}

}  // namespace
}  // namespace leda::db
