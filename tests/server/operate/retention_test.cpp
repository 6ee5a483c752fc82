#include "server/operate/retention.hpp"

#include <gtest/gtest.h>

#include "server/jobs/process.hpp"
#include "server/layers/features.hpp"
#include "tests/server/run_fixture.hpp"
#include "tests/server/temporary_folder.hpp"

namespace leda::server {
namespace {

namespace fs = std::filesystem;

class RetentionTest : public testing::Test {
 protected:
  RetentionTest() {
    add("old", db::JobState::successful);
    add("now", db::JobState::accepted);
    fs::create_directories(data.run("stray"));
    tests::write_text(data.exports() / "old-20260101.gpkg", "12345");
  }

  void add(const std::string& id, db::JobState state) {
    db::JobRecord job;
    job.id = id;
    job.process = "simulate-section";
    job.request = tests::simulate_request();
    store.add_job(job);
    const auto work = find_process(job.process)->open(job.request, {data, store});
    store.set_sections(id, work->plan());
    const std::string run = id + "-0-1";
    fs::create_directories(data.run(run));
    tests::write_text(data.run(run) / "log.txt", "hello\n");
    tests::write_text(data.run(run) / "fields.h5", "fields");
    store.start_run(store.sections(id).at(0).id, run);
    store.set_job_state(id, state, "");
  }

  tests::TemporaryFolder folder;
  DataFolder data{folder.path() / "data"};
  db::Store store{data.store()};
};

TEST_F(RetentionTest, OldJobsLoseTheirFoldersAndKeepTheirRows) {
  const Purged purged = purge(data, store, 0, false);
  EXPECT_EQ(purged.run_folders, 2U);  // of the finished job, and the stray
  EXPECT_EQ(purged.jobs, 0U);
  EXPECT_EQ(purged.bytes, 6U + 6U + 5U);
  EXPECT_FALSE(fs::exists(data.run("old-0-1")));
  EXPECT_FALSE(fs::exists(data.run("stray")));
  EXPECT_TRUE(fs::exists(data.run("now-0-1")));
  EXPECT_TRUE(fs::is_empty(data.exports()));
  EXPECT_TRUE(store.job("old").has_value());
}

TEST_F(RetentionTest, YoungJobsStay) {
  const Purged purged = purge(data, store, 1, true);
  EXPECT_EQ(purged.run_folders, 0U);
  EXPECT_TRUE(fs::exists(data.run("old-0-1")));
  EXPECT_TRUE(fs::exists(data.run("stray")));
  EXPECT_TRUE(store.job("old").has_value());
}

TEST_F(RetentionTest, TheJobsThemselvesGoWhereAsked) {
  EXPECT_EQ(purge(data, store, 0, true).jobs, 1U);
  EXPECT_FALSE(store.job("old").has_value());
  EXPECT_TRUE(store.job("now").has_value());
}

TEST_F(RetentionTest, ABackupIsADataFolder) {
  const auto out = folder.path() / "backup";
  const BackedUp done = back_up(data, out, true);
  EXPECT_EQ(done.run_folders, 2U);
  const DataFolder copy(out);
  const db::Store rows(copy.store());
  EXPECT_EQ(rows.sections("old").at(0).run, "old-0-1");
  EXPECT_EQ(tests::read_text(copy.run("old-0-1") / "fields.h5"), "fields");
  EXPECT_FALSE(fs::exists(folder.path() / "backup.part"));
  EXPECT_THROW(back_up(data, out, true), DataFolderError);
}

TEST_F(RetentionTest, ABackupMayLeaveOutTheFields) {
  back_up(data, folder.path() / "small", false);
  const DataFolder copy(folder.path() / "small");
  EXPECT_TRUE(fs::exists(copy.run("old-0-1") / "log.txt"));
  EXPECT_FALSE(fs::exists(copy.run("old-0-1") / "fields.h5"));
}

}  // namespace
}  // namespace leda::server
