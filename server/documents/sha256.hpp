#pragma once

#include <string>
#include <string_view>

namespace leda::server {

/// 64 lower-case hex digits.
std::string sha256(std::string_view bytes);

}  // namespace leda::server
