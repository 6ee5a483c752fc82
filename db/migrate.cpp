#include "db/migrate.hpp"

#include "db/database.hpp"
#include "db/store.hpp"

namespace leda::db {

namespace {

// PRAGMA application_id of every store: "Leda" in ASCII. Migration 1 writes it.
constexpr std::int64_t leda_id = 0x4C656461;

std::int64_t number(Database& database, const std::string& sql) {
  Query query(database, sql);
  query.next();
  return query.integer();
}

void refuse_foreign_files(Database& database, std::int64_t version) {
  if (version == 0 && number(database, "SELECT count(*) FROM sqlite_schema") == 0) return;
  if (number(database, "PRAGMA application_id") == leda_id) return;
  throw StoreError(database.file() + ": this SQLite file is not a store of Leda; name another");
}

}  // namespace

void migrate(Database& database, const std::vector<Migration>& steps) {
  database.write([&] {
    const std::int64_t version = number(database, "PRAGMA user_version");
    refuse_foreign_files(database, version);
    const int newest = steps.empty() ? 0 : steps.back().version;
    if (version > newest)
      throw StoreError(database.file() + ": schema version " + std::to_string(version) +
                       " was made by a newer Leda; this one knows up to " + std::to_string(newest));
    for (const Migration& step : steps)
      if (step.version > version) database.run_script(step.sql);
    // A pragma takes no bound value; `newest` is a number of ours.
    if (version < newest) database.run_script("PRAGMA user_version = " + std::to_string(newest));
  });
}

}  // namespace leda::db
