#include "db/store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <memory>
#include <thread>

#include "tests/db/samples.hpp"

namespace leda::db {
namespace {

using namespace std::chrono_literals;
using samples::job;
using samples::ScratchFolder;

TEST(StoreFile, AFolderThatDoesNotStandIsNamed) {
  const ScratchFolder folder;
  try {
    Store store(folder / "nowhere/leda.sqlite");
    FAIL() << "should have thrown";
  } catch (const StoreError& error) {
    EXPECT_NE(std::string(error.what()).find("nowhere/leda.sqlite"), std::string::npos);
  }
}

TEST(StoreFile, WhatIsNoSqliteFileIsRefusedAndLeftAlone) {
  const ScratchFolder folder;
  const std::string text(5000, 'x');
  std::ofstream(folder / "leda.sqlite") << text;
  EXPECT_THROW(Store store(folder / "leda.sqlite"), StoreError);
  EXPECT_EQ(std::filesystem::file_size(folder / "leda.sqlite"), text.size());
}

TEST(StoreFile, TwoStoresSeeEachOthersRows) {
  const ScratchFolder folder;
  Store one(folder / "leda.sqlite");
  Store two(folder / "leda.sqlite");
  one.add_job(job("job-1"));
  ASSERT_TRUE(two.job("job-1").has_value());
  two.set_job_state("job-1", JobState::running, "from two");
  EXPECT_EQ(one.job("job-1")->message, "from two");
}

TEST(StoreFile, StoresOpenedAtOnceMigrateOnce) {
  const ScratchFolder folder;
  std::vector<std::thread> threads;
  threads.reserve(6);
  for (int i = 0; i < 6; ++i)
    threads.emplace_back([&, i] {
      Store store(folder / "leda.sqlite");
      store.add_job(job(samples::numbered("job-", i)));
    });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(Store(folder / "leda.sqlite").count_jobs({}), 6);
}

// A write that has to wait, here for another program, holds nobody up who only looks.
TEST(StoreFile, ReadersDoNotWaitForAWriter) {
  const ScratchFolder folder;
  Store store(folder / "leda.sqlite", 60s);
  store.add_job(job("job-1"));
  SQLite::Database other((folder / "leda.sqlite").string(), SQLite::OPEN_READWRITE);
  auto held = std::make_unique<SQLite::Transaction>(other, SQLite::TransactionBehavior::IMMEDIATE);
  std::atomic<bool> written{false};
  std::thread writer([&] {
    store.add_job(job("job-2"));
    written = true;
  });
  std::this_thread::sleep_for(100ms);
  EXPECT_EQ(store.count_jobs({}), 1);
  EXPECT_TRUE(store.job("job-1").has_value());
  EXPECT_FALSE(written);
  held.reset();
  writer.join();
  EXPECT_EQ(store.count_jobs({}), 2);
}

TEST(StoreFile, MoreThreadsReadThanThereAreReaders) {
  const ScratchFolder folder;
  Store store(folder / "leda.sqlite");
  store.add_job(job("job-1"));
  std::atomic<int> found{0};
  std::vector<std::thread> threads;
  threads.reserve(40);
  for (int i = 0; i < 40; ++i)
    threads.emplace_back([&] {
      for (int k = 0; k < 50; ++k) found += store.job("job-1").has_value() ? 1 : 0;
    });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(found, 2000);
}

TEST(StoreFile, ThreadsThatWriteTakeTurns) {
  const ScratchFolder folder;
  Store store(folder / "leda.sqlite");
  std::vector<std::thread> threads;
  threads.reserve(4);
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&, i] {
      for (int k = 0; k < 25; ++k) {
        const std::string id = std::to_string(i) + "-" + std::to_string(k);
        store.add_job(job(id));
        store.set_job_state(id, JobState::running, "");
        EXPECT_TRUE(store.job(id).has_value());
      }
    });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(store.count_jobs({.states = {JobState::running}}), 100);
}

TEST(StoreFile, ABusyStoreIsWaitedFor) {
  const ScratchFolder folder;
  Store store(folder / "leda.sqlite", 20s);
  SQLite::Database other((folder / "leda.sqlite").string(), SQLite::OPEN_READWRITE);
  other.exec("BEGIN IMMEDIATE");
  std::thread frees([&] {
    std::this_thread::sleep_for(200ms);
    other.exec("COMMIT");
  });
  store.add_job(job());
  frees.join();
  EXPECT_TRUE(store.job("job-1").has_value());
}

TEST(StoreFile, AStoreBusyForTooLongIsSaidAndCanBeReadMeanwhile) {
  const ScratchFolder folder;
  Store store(folder / "leda.sqlite", 50ms);
  store.add_job(job("job-1"));
  SQLite::Database other((folder / "leda.sqlite").string(), SQLite::OPEN_READWRITE);
  other.exec("BEGIN IMMEDIATE");
  try {
    store.add_job(job("job-2"));
    FAIL() << "should have thrown";
  } catch (const StoreError& error) {
    EXPECT_NE(std::string(error.what()).find("another program"), std::string::npos);
  }
  EXPECT_TRUE(store.job("job-1").has_value());
  other.exec("ROLLBACK");
  store.add_job(job("job-2"));
  EXPECT_EQ(store.count_jobs({}), 2);
}

TEST(StoreFile, TheViewTellsWhatIsAskedMost) {
  const ScratchFolder folder;
  Store store(folder / "leda.sqlite");
  store.add_raster(samples::raster("dem-1"));
  JobRecord with_dem = job();
  with_dem.raster = "dem-1";
  store.add_job(with_dem);
  store.set_sections("job-1", samples::layout(2));
  const auto first = store.section("job-1", "S1").value();
  store.start_run(first.id, "run-1");
  store.take_in(first.id, "run-1", samples::result(), samples::placed(first), "{}");

  SQLite::Database raw((folder / "leda.sqlite").string());
  SQLite::Statement rows(raw,
                         "SELECT dem_sha256, section, state, status, retrogression_m, runout_m, "
                         "case_sha256 FROM section_results");
  ASSERT_TRUE(rows.executeStep());
  EXPECT_EQ(rows.getColumn(0).getString(), std::string(64, 'a'));
  EXPECT_EQ(rows.getColumn(1).getString(), "S1");
  EXPECT_EQ(rows.getColumn(2).getString(), "finished");
  EXPECT_EQ(rows.getColumn(3).getString(), "at-rest");
  EXPECT_EQ(rows.getColumn(4).getDouble(), 103.2);
  EXPECT_EQ(rows.getColumn(5).getDouble(), 52.4);
  EXPECT_EQ(rows.getColumn(6).getString(), std::string(64, 'c'));
  ASSERT_TRUE(rows.executeStep());
  EXPECT_EQ(rows.getColumn(2).getString(), "waiting");
  EXPECT_TRUE(rows.getColumn(4).isNull());
  EXPECT_FALSE(rows.executeStep());
}

}  // namespace
}  // namespace leda::db
