#pragma once
// Lists in header fields: parts with commas or semicolons between, blanks around them.

#include <algorithm>
#include <string_view>

namespace leda::server {

inline std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  text.remove_suffix(text.size() - (text.find_last_not_of(blanks) + 1));
  return text;
}

/// The part before the separator, which is taken off `rest` together with it.
inline std::string_view take_part(std::string_view& rest, char separator) {
  const auto at = std::min(rest.find(separator), rest.size());
  const std::string_view part = without_blanks(rest.substr(0, at));
  rest.remove_prefix(std::min(at + 1, rest.size()));
  return part;
}

}  // namespace leda::server
