#pragma once
// The table of everything the service answers.

#include <span>

#include "server/http/router.hpp"

namespace leda::server {

std::span<const Route> routes();

}  // namespace leda::server
