#include "db/migrate.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "db/database.hpp"
#include "db/store.hpp"
#include "tests/db/samples.hpp"

namespace leda::db {
namespace {

using namespace std::chrono_literals;
using samples::ScratchFolder;

std::int64_t number(Database& database, const std::string& sql) {
  return database.read([&] {
    Query query(database, sql);
    query.next();
    return query.integer();
  });
}

std::vector<Migration> with_one_more(const std::string& sql) {
  std::vector<Migration> steps = migrations();
  steps.push_back({steps.back().version + 1, "made_up.sql", sql});
  return steps;
}

TEST(Migrate, TheStepsAreNumberedFromOne) {
  ASSERT_FALSE(migrations().empty());
  for (std::size_t i = 0; i < migrations().size(); ++i)
    EXPECT_EQ(migrations()[i].version, static_cast<int>(i) + 1);
  EXPECT_EQ(migrations()[0].file, "0001_initial.sql");
}

TEST(Migrate, AnEmptyFileBecomesTheNewestSchema) {
  const ScratchFolder folder;
  std::ofstream(folder / "leda.sqlite").close();
  Store store(folder / "leda.sqlite");
  store.add_job(samples::job());
  Database raw(folder / "leda.sqlite", 1s);
  EXPECT_EQ(number(raw, "PRAGMA user_version"), migrations().back().version);
  EXPECT_EQ(number(raw, "PRAGMA application_id"), 0x4C656461);
}

TEST(Migrate, VersionOneKeepsItsRowsAndGoesOn) {
  const ScratchFolder folder;
  const auto file = folder / "leda.sqlite";
  Database first(file, 1s);
  migrate(first, {migrations()[0]});
  first.write([&] {
    first.run_script(
        "INSERT INTO jobs (id, process, name, state, message, progress, request, created, "
        "updated) VALUES ('old', 'map-region', 'n', 'running', '', 5, '{}', "
        "'2026-01-01T00:00:00.000Z', '2026-01-01T00:00:00.000Z')");
  });
  Store store(file);
  ASSERT_TRUE(store.job("old").has_value());
  EXPECT_EQ(store.job("old")->progress, 5);
  EXPECT_EQ(number(first, "PRAGMA user_version"), migrations().back().version);
}

TEST(Migrate, ALaterStepIsAppliedOnce) {
  const ScratchFolder folder;
  const auto file = folder / "leda.sqlite";
  {
    Store store(file);
    store.add_job(samples::job());
  }
  Database database(file, 1s);
  const auto steps = with_one_more("ALTER TABLE jobs ADD COLUMN colour TEXT DEFAULT 'blue'");
  migrate(database, steps);
  migrate(database, steps);
  EXPECT_EQ(number(database, "PRAGMA user_version"), steps.back().version);
  EXPECT_EQ(number(database, "SELECT count(*) FROM jobs WHERE colour = 'blue'"), 1);
}

TEST(Migrate, AFailingStepLeavesTheFileAsItWas) {
  const ScratchFolder folder;
  const auto file = folder / "leda.sqlite";
  { Store store(file); }
  Database database(file, 1s);
  const auto steps = with_one_more("CREATE TABLE half (a); INSERT INTO no_such_table VALUES (1)");
  EXPECT_THROW(migrate(database, steps), StoreError);
  EXPECT_EQ(number(database, "PRAGMA user_version"), migrations().back().version);
  EXPECT_EQ(number(database, "SELECT count(*) FROM sqlite_schema WHERE name = 'half'"), 0);
}

TEST(Migrate, AFileOfANewerLedaIsLeftAlone) {
  const ScratchFolder folder;
  const auto file = folder / "leda.sqlite";
  { Store store(file); }
  Database database(file, 1s);
  database.write([&] { database.run_script("PRAGMA user_version = 999"); });
  try {
    Store store(file);
    FAIL() << "should have thrown";
  } catch (const StoreError& error) {
    EXPECT_NE(std::string(error.what()).find("999"), std::string::npos) << error.what();
  }
}

TEST(Migrate, AForeignSqliteFileIsRefused) {
  const ScratchFolder folder;
  const auto file = folder / "other.sqlite";
  {
    Database database(file, 1s);
    database.write([&] { database.run_script("CREATE TABLE theirs (a)"); });
  }
  EXPECT_THROW(Store store(file), StoreError);
  Database database(file, 1s);
  EXPECT_EQ(number(database, "SELECT count(*) FROM sqlite_schema"), 1);
}

}  // namespace
}  // namespace leda::db
