#include "db/store.hpp"

#include <fmt/chrono.h>

#include <chrono>

#include "db/connection.hpp"
#include "db/migrate.hpp"

namespace leda::db {

Store::Store(const std::filesystem::path& file, std::chrono::milliseconds busy_timeout)
    : connection_(std::make_unique<Connection>(file, busy_timeout)) {
  migrate(connection_->writer(), migrations());
}

Store::~Store() = default;

std::string utc_now() {
  using namespace std::chrono;
  const auto now = floor<milliseconds>(system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(system_clock::to_time_t(now)),
                     now.time_since_epoch().count() % 1000);
}

}  // namespace leda::db
