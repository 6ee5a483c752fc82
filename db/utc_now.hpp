#pragma once

#include <chrono>
#include <string>

namespace leda::db {

/// UTC, "2026-01-31T12:00:00.000Z".
std::string utc_text(std::chrono::system_clock::time_point time);

/// The same of now.
std::string utc_now();

}  // namespace leda::db
