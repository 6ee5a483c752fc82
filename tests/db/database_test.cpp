#include "db/database.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "db/store.hpp"
#include "tests/db/samples.hpp"

namespace leda::db {
namespace {

using namespace std::chrono_literals;

class DatabaseTest : public ::testing::Test {
 protected:
  DatabaseTest() {
    database.write([&] { database.run_script("CREATE TABLE t (a TEXT PRIMARY KEY, b REAL)"); });
  }
  void insert(const std::string& a, double b) {
    Query(database, "INSERT INTO t VALUES (?, ?)").with(a, b).run();
  }
  std::int64_t rows() {
    return database.read([&] {
      Query count(database, "SELECT count(*) FROM t");
      count.next();
      return count.integer();
    });
  }
  samples::ScratchFolder folder;
  Database database{folder / "t.sqlite", 100ms};
};

TEST_F(DatabaseTest, AnExceptionUndoesTheWholeTransaction) {
  EXPECT_THROW(database.write([&] {
    insert("one", 1);
    throw std::runtime_error("half way");
  }),
               std::runtime_error);
  EXPECT_EQ(rows(), 0);
  EXPECT_THROW(database.write([&] {
    insert("one", 1);
    insert("one", 2);
  }),
               StoreConflict);
  EXPECT_EQ(rows(), 0);
  database.write([&] { insert("one", 1); });
  EXPECT_EQ(rows(), 1) << "the connection is fit to go on";
}

TEST_F(DatabaseTest, ValuesKeepTheirBytesAndNaNIsNull) {
  const std::string with_nul("a\0b", 3);
  database.write([&] { insert(with_nul, std::nan("")); });
  database.read([&] {
    Query row(database, "SELECT a, b, b IS NULL FROM t");
    ASSERT_TRUE(row.next());
    EXPECT_EQ(row.text(), with_nul);
    EXPECT_TRUE(row.is_null());
    EXPECT_TRUE(std::isnan(row.real()));
    EXPECT_EQ(row.integer(), 1);
    EXPECT_FALSE(row.next());
  });
}

TEST_F(DatabaseTest, AStatementOnLoanComesBackClean) {
  database.write([&] {
    insert("a", 1);
    insert("b", 2);
  });
  const std::string sql = "SELECT a FROM t WHERE a >= ? ORDER BY a";
  database.read([&] {
    Query left_early(database, sql);
    EXPECT_TRUE(left_early.with("a").next());
  });
  database.read([&] {
    Query unbound(database, sql);
    EXPECT_FALSE(unbound.next()) << "the value bound before is gone";
  });
}

TEST_F(DatabaseTest, TheFileIsInWalModeAndSynced) {
  database.read([&] {
    Query journal(database, "PRAGMA journal_mode");
    ASSERT_TRUE(journal.next());
    EXPECT_EQ(journal.text(), "wal");
    Query synchronous(database, "PRAGMA synchronous");
    ASSERT_TRUE(synchronous.next());
    EXPECT_EQ(synchronous.integer(), 2) << "FULL";
    Query keys(database, "PRAGMA foreign_keys");
    ASSERT_TRUE(keys.next());
    EXPECT_EQ(keys.integer(), 1);
  });
}

TEST_F(DatabaseTest, FaultySqlNamesTheFile) {
  try {
    database.write([&] { database.run_script("NONSENSE"); });
    FAIL() << "should have thrown";
  } catch (const StoreError& error) {
    EXPECT_NE(std::string(error.what()).find("t.sqlite"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace leda::db
