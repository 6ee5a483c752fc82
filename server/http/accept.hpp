#pragma once
// Content negotiation (RFC 9110, 12.5.1): which of several media types a client would rather have.

#include <compare>
#include <string_view>

namespace leda::server {

/// How much a media type is wanted; the larger the better.
struct Want {
  double quality = 0;  ///< q of the entry that fits best; 0: not acceptable
  int exactness = 0;   ///< 3: the type itself, 2: type/*, 1: */* or no header
  auto operator<=>(const Want&) const = default;
};

/// @param accept the header; empty: all is welcome
/// @param media_type without parameters. JSON and its dialects (geo+json, schema+json) count as
/// one.
Want wanted(std::string_view accept, std::string_view media_type);

}  // namespace leda::server
