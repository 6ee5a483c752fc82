#include "db/store.hpp"

#include "db/connection.hpp"
#include "db/migrate.hpp"

namespace leda::db {

Store::Store(const std::filesystem::path& file, std::chrono::milliseconds busy_timeout)
    : connection_(std::make_unique<Connection>(file, busy_timeout)) {
  migrate(connection_->writer(), migrations());
}

Store::~Store() = default;

}  // namespace leda::db
