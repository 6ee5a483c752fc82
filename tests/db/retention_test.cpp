// Copies of a store that is in use, and what may be removed.

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "db/store.hpp"
#include "tests/db/samples.hpp"

namespace leda::db {
namespace {

class Retention : public ::testing::Test {
 protected:
  Retention() {
    store.add_job(samples::job());
    store.set_sections("job-1", samples::layout(3));
  }
  samples::ScratchFolder folder;
  Store store{folder / "leda.sqlite"};
};

TEST_F(Retention, ACopyIsWholeWhileTheStoreIsWritten) {
  std::atomic<bool> stop = false;
  std::thread writer([&] {
    for (int i = 0; !stop; ++i) {
      const std::string id = samples::numbered("busy-", i);
      store.add_job(samples::job(id));
      store.set_sections(id, samples::layout(5));
    }
  });
  for (int i = 0; i < 20; ++i) back_up(folder / "leda.sqlite", folder / "copy.sqlite");
  stop = true;
  writer.join();
  const Store copy(folder / "copy.sqlite");
  EXPECT_EQ(copy.sections("job-1").size(), 3U);
  EXPECT_LE(copy.count_jobs({}), store.count_jobs({}));
  EXPECT_FALSE(std::filesystem::exists(folder / "copy.sqlite.part"));
}

TEST_F(Retention, ACopyOfNothingIsAnErrorAndLeavesNothing) {
  EXPECT_THROW(back_up(folder / "none.sqlite", folder / "copy.sqlite"), StoreError);
  std::ofstream(folder / "text.sqlite") << std::string(5000, 'x');
  EXPECT_THROW(back_up(folder / "text.sqlite", folder / "copy.sqlite"), StoreError);
  EXPECT_FALSE(std::filesystem::exists(folder / "copy.sqlite"));
}

TEST_F(Retention, OnlyFinishedJobsAreRemoved) {
  EXPECT_FALSE(store.remove_job("job-1"));
  const auto section = store.section("job-1", "S1").value();
  store.start_run(section.id, "run-1");
  store.take_in(section.id, "run-1", samples::result(), samples::placed(section), "{}");
  EXPECT_EQ(store.latest_runs(), std::vector<std::string>{"run-1"});
  EXPECT_EQ(store.run_folders("job-1"), std::vector<std::string>{"run-1"});
  EXPECT_TRUE(store.has_run("run-1"));
  EXPECT_TRUE(store.jobs_finished_before("9999").empty());
  store.set_job_state("job-1", JobState::failed, "");
  EXPECT_EQ(store.jobs_finished_before("9999"), std::vector<std::string>{"job-1"});
  EXPECT_TRUE(store.jobs_finished_before("2000").empty());
  EXPECT_TRUE(store.remove_job("job-1"));
  EXPECT_FALSE(store.job("job-1").has_value());
  EXPECT_TRUE(store.sections("job-1").empty());
  EXPECT_FALSE(store.has_run("run-1"));
  EXPECT_FALSE(store.remove_job("job-1"));
}

TEST_F(Retention, ATypicalRunIsTheMedianOfTheResults) {
  EXPECT_FALSE(store.typical_run().has_value());
  int number = 0;
  for (const double cost : {40.0, 50.0, 900.0}) {
    const auto section = store.sections("job-1").at(static_cast<std::size_t>(number)).id;
    const std::string run = samples::numbered("run-", number++);
    store.start_run(section, run);
    SectionResult result = samples::result();
    result.ns_per_particle_step = cost;
    result.simulated_s = 10;
    result.steps = 4000;
    store.take_in(section, run, result, {}, "{}");
  }
  const auto typical = store.typical_run();
  ASSERT_TRUE(typical.has_value());
  EXPECT_EQ(typical->runs, 3);
  EXPECT_EQ(typical->ns_per_particle_step, 50);
  EXPECT_EQ(typical->steps_per_simulated_s, 400);
}

}  // namespace
}  // namespace leda::db
