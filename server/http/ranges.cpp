#include "server/http/ranges.hpp"

#include <algorithm>
#include <charconv>

#include "server/http/header_list.hpp"

namespace leda::server {
namespace {

constexpr std::size_t most_ranges = 16;
constexpr std::string_view unit = "bytes=";

std::optional<std::uint64_t> number(std::string_view text) {
  std::uint64_t value = 0;
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (text.empty() || error != std::errc{} || end != last) return std::nullopt;
  return value;
}

/// One "first-last", "first-" or "-suffix".
struct Part {
  bool well_formed = false;
  std::optional<ByteRange> bytes;  ///< none: beyond the end
};

Part part_of(std::string_view text, std::uint64_t length) {
  const auto dash = text.find('-');
  if (dash == std::string_view::npos) return {};
  const auto first = number(text.substr(0, dash)), last = number(text.substr(dash + 1));
  const bool first_given = dash > 0, last_given = dash + 1 < text.size();
  if ((first_given && !first) || (last_given && !last) || (!first_given && !last_given)) return {};
  if (first && last && *first > *last) return {};
  if (!first) {
    const std::uint64_t count = std::min(*last, length);
    return {true, count > 0 ? std::optional(ByteRange{length - count, length - 1}) : std::nullopt};
  }
  if (*first >= length) return {true, std::nullopt};
  return {true, ByteRange{*first, std::min(last.value_or(length - 1), length - 1)}};
}

}  // namespace

std::optional<std::vector<ByteRange>> wanted_ranges(std::string_view range, std::uint64_t length) {
  if (!range.starts_with(unit)) return std::nullopt;
  range.remove_prefix(unit.size());
  std::vector<ByteRange> wanted;
  std::uint64_t bytes = 0;
  for (std::size_t count = 0; count == 0 || !range.empty(); ++count) {
    const Part part = part_of(take_part(range, ','), length);
    if (!part.well_formed || count == most_ranges) return std::nullopt;
    if (part.bytes) {
      bytes += part.bytes->last - part.bytes->first + 1;
      wanted.push_back(*part.bytes);
    }
  }
  if (bytes > length) return std::nullopt;  // they overlap
  return wanted;
}

}  // namespace leda::server
