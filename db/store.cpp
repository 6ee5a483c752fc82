#include "db/store.hpp"

#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>

#include "db/connection.hpp"
#include "db/migrate.hpp"

namespace leda::db {

Store::Store(const std::filesystem::path& file, std::chrono::milliseconds busy_timeout)
    : connection_(std::make_unique<Connection>(file, busy_timeout)) {
  migrate(*connection_, migrations());
}

Store::~Store() = default;

std::string utc_now() {
  using namespace std::chrono;
  const auto now = floor<milliseconds>(system_clock::now());
  const std::time_t second = system_clock::to_time_t(now);
  std::tm utc{};
  gmtime_r(&second, &utc);
  std::array<char, 32> date{};
  std::strftime(date.data(), date.size(), "%Y-%m-%dT%H:%M:%S", &utc);
  std::array<char, 8> fraction{};
  const auto ms = static_cast<int>(now.time_since_epoch().count() % 1000);
  std::snprintf(fraction.data(), fraction.size(), ".%03dZ", ms);
  return std::string(date.data()) + fraction.data();
}

}  // namespace leda::db
