#pragma once
// Text to JSON value, for text that strangers send.

#include <nlohmann/json.hpp>
#include <string_view>

#include "server/documents/parsed.hpp"

namespace leda::server {

/// Deeper documents are refused before anything is built from them.
inline constexpr int most_nesting = 32;

/// Faults: empty text, broken syntax (line and column), text after the end, a key that occurs
/// twice, a number too large for a double, nesting beyond most_nesting.
Parsed<nlohmann::json> parse_json(std::string_view text);

}  // namespace leda::server
