#include "db/utc_now.hpp"

#include <fmt/chrono.h>

namespace leda::db {

std::string utc_text(std::chrono::system_clock::time_point time) {
  using namespace std::chrono;
  const auto whole = floor<milliseconds>(time);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(system_clock::to_time_t(whole)),
                     whole.time_since_epoch().count() % 1000);
}

std::string utc_now() { return utc_text(std::chrono::system_clock::now()); }

}  // namespace leda::db
