#pragma once
// Parts of an answer (RFC 9110, 14): what a Range header asks for.

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace leda::server {

struct ByteRange {
  std::uint64_t first = 0, last = 0;  ///< both included
  bool operator==(const ByteRange&) const = default;
};

/// What of `length` bytes is wanted, in the order asked for. Nothing: all of them, since the header
/// is absent, not of bytes, not well formed, or asks for more than all in many pieces. An empty
/// list: no such bytes (416).
std::optional<std::vector<ByteRange>> wanted_ranges(std::string_view range, std::uint64_t length);

}  // namespace leda::server
