#include "db/database.hpp"

#include <sqlite3.h>

#include <cmath>
#include <limits>

#include "db/store.hpp"

namespace leda::db {

namespace {

SQLite::Database open(const std::filesystem::path& file, std::chrono::milliseconds busy_timeout,
                      Database::Access access) {
  const bool writes = access == Database::Access::write;
  try {
    SQLite::Database connection(
        file.string(),
        writes ? SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE : SQLite::OPEN_READONLY,
        static_cast<int>(busy_timeout.count()));
    sqlite3_extended_result_codes(connection.getHandle(), 1);
    if (!writes) return connection;
    connection.exec("PRAGMA journal_mode = WAL");
    // FULL: each commit is on the disk before it is answered for, also when the power fails.
    connection.exec("PRAGMA synchronous = FULL");
    connection.exec("PRAGMA foreign_keys = ON");
    return connection;
  } catch (const SQLite::Exception& error) {
    throw StoreError(file.string() + ": the store cannot be opened: " + error.what());
  }
}

}  // namespace

Database::Database(const std::filesystem::path& file, std::chrono::milliseconds busy_timeout,
                   Access access)
    : file_(file.string()), connection_(open(file, busy_timeout, access)) {}

SQLite::Statement& Database::prepared(const std::string& sql) {
  const auto found = prepared_.find(sql);
  if (found != prepared_.end()) return found->second;
  return prepared_.emplace(sql, SQLite::Statement(connection_, sql)).first->second;
}

void Database::fail(const SQLite::Exception& error) const {
  const std::string what = file_ + ": " + error.what();
  const int code = error.getExtendedErrorCode();
  if (code == SQLITE_CONSTRAINT_UNIQUE || code == SQLITE_CONSTRAINT_PRIMARYKEY)
    throw StoreConflict(what);
  if (error.getErrorCode() == SQLITE_BUSY)
    throw StoreError(what + ": another program has been writing to the store for too long");
  throw StoreError(what);
}

Query::Query(Database& database, const std::string& sql) : statement_(database.prepared(sql)) {}

Query::~Query() {
  statement_.tryReset();
  statement_.clearBindings();
}

bool Query::next() {
  column_ = 0;
  return statement_.executeStep();
}

int Query::run() {
  const int changed = statement_.exec();
  statement_.reset();
  return changed;
}

bool Query::is_null() const { return statement_.getColumn(column_).isNull(); }

std::string Query::text() { return statement_.getColumn(column_++).getString(); }

std::optional<double> Query::optional_real() {
  const bool null = is_null();
  const double value = real();
  return null ? std::nullopt : std::optional(value);
}

double Query::real() {
  const SQLite::Column column = statement_.getColumn(column_++);
  return column.isNull() ? std::numeric_limits<double>::quiet_NaN() : column.getDouble();
}

std::int64_t Query::integer() { return statement_.getColumn(column_++).getInt64(); }

}  // namespace leda::db
