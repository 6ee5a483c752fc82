#pragma once

#include <string>

namespace leda::db {

/// Now, UTC, "2026-01-31T12:00:00.000Z".
std::string utc_now();

}  // namespace leda::db
