#pragma once
// One connection to SQLite: transactions, and prepared statements kept for reuse. Private to db/.

#include <SQLiteCpp/SQLiteCpp.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <type_traits>

namespace leda::db {

/// Threads take turns: a transaction belongs to the connection, so it has to be one thread's.
class Database {
 public:
  enum class Access { write, read };

  /// Opens or makes the file: WAL, foreign keys on, synchronous=FULL. For reading it has to be
  /// there already, and no statement can change it. Throws StoreError.
  Database(const std::filesystem::path& file, std::chrono::milliseconds busy_timeout,
           Access access = Access::write);

  /// Runs `work` as one transaction that may change things; an exception undoes all of it.
  /// SQLite's own errors come out as StoreError or StoreConflict.
  template <class Work>
  auto write(Work work) {
    return transaction(SQLite::TransactionBehavior::IMMEDIATE, work);
  }

  /// Runs `work` on one unchanging view of the data.
  template <class Work>
  auto read(Work work) {
    return transaction(SQLite::TransactionBehavior::DEFERRED, work);
  }

  /// Several statements at once; inside write() only.
  void run_script(const std::string& sql) { connection_.exec(sql); }

  const std::string& file() const { return file_; }

 private:
  friend class Query;
  SQLite::Statement& prepared(const std::string& sql);
  [[noreturn]] void fail(const SQLite::Exception& error) const;

  template <class Work>
  auto transaction(SQLite::TransactionBehavior behavior, Work& work) {
    const std::lock_guard lock(mutex_);
    try {
      SQLite::Transaction open(connection_, behavior);
      if constexpr (std::is_void_v<std::invoke_result_t<Work&>>) {
        work();
        open.commit();
      } else {
        auto answer = work();
        open.commit();
        return answer;
      }
    } catch (const SQLite::Exception& error) {
      fail(error);
    }
  }

  std::string file_;
  std::mutex mutex_;
  SQLite::Database connection_;
  std::map<std::string, SQLite::Statement> prepared_;
};

/// A prepared statement on loan: reset when it goes out of scope, so that it holds no lock.
/// Columns are read from left to right, one call a column. A NULL reads as "", 0 or NaN.
class Query {
 public:
  Query(Database& database, const std::string& sql);
  ~Query();
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;

  template <class... Values>
  Query& with(const Values&... values) {
    int index = 0;
    (bind(++index, values), ...);
    return *this;
  }

  /// The same for statements that need not have a place for the last of the values.
  template <class... Values>
  Query& with_some(const Values&... values) {
    int index = 0;
    const int places = statement_.getBindParameterCount();
    (void)((++index <= places && (bind(index, values), true)) && ...);
    return *this;
  }

  bool next();  ///< to the next row; false after the last
  int run();    ///< for a statement without rows; the number of rows changed

  std::string text();
  double real();
  std::optional<double> optional_real();
  std::int64_t integer();
  int small_integer() { return static_cast<int>(integer()); }
  bool is_null() const;  ///< the column that would be read next

 private:
  void bind(int index, const std::string& value) { statement_.bind(index, value); }
  void bind(int index, const char* value) { statement_.bind(index, value); }
  void bind(int index, double value) { statement_.bind(index, value); }  // NaN becomes NULL
  void bind(int index, const std::optional<double>& value) {
    value ? statement_.bind(index, *value) : statement_.bind(index);
  }
  void bind(int index, std::int64_t value) { statement_.bind(index, value); }
  void bind(int index, int value) { statement_.bind(index, value); }
  void bind(int index, const std::optional<int>& value) {
    value ? statement_.bind(index, *value) : statement_.bind(index);
  }
  void bind(int index, bool value) { statement_.bind(index, value ? 1 : 0); }
  void bind(int index, const std::optional<std::string>& value) {
    value ? statement_.bind(index, *value) : statement_.bind(index);
  }

  SQLite::Statement& statement_;
  int column_ = 0;
};

}  // namespace leda::db
