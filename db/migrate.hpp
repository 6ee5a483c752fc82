#pragma once
// The schema's history: numbered steps, each applied once and never edited.

#include <string>
#include <vector>

namespace leda::db {

class Database;

struct Migration {
  int version = 0;  ///< 1, 2, ...
  std::string file;
  std::string sql;
};

/// The files of db/migrations, in order; written at build time.
const std::vector<Migration>& migrations();

/// Brings a database to the newest version in one transaction: all steps or none.
/// Throws StoreError when the file is not Leda's, or was made by a newer Leda.
void migrate(Database& database, const std::vector<Migration>& steps);

}  // namespace leda::db
