#include "tests/server/held_store.hpp"

#include <sqlite3.h>

#include <stdexcept>

namespace leda::tests {

HeldStore::HeldStore(const std::filesystem::path& store) {
  constexpr int patience_ms = 20'000;  // the server writes to it meanwhile
  const bool open =
      sqlite3_open_v2(store.c_str(), &connection_, SQLITE_OPEN_READWRITE, nullptr) == SQLITE_OK;
  sqlite3_busy_timeout(connection_, patience_ms);
  if (open && sqlite3_exec(connection_, "BEGIN IMMEDIATE", nullptr, nullptr, nullptr) == SQLITE_OK)
    return;
  const std::string why = sqlite3_errmsg(connection_);
  sqlite3_close(connection_);
  throw std::runtime_error(store.string() + " cannot be held: " + why);
}

HeldStore::~HeldStore() {
  sqlite3_exec(connection_, "ROLLBACK", nullptr, nullptr, nullptr);
  sqlite3_close(connection_);
}

}  // namespace leda::tests
