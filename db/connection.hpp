#pragma once
// What stands behind a Store. Private to db/.

#include "db/database.hpp"
#include "db/store.hpp"

namespace leda::db {

class Store::Connection : public Database {
 public:
  using Database::Database;
};

}  // namespace leda::db
