#include "server/http/accept.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string>

#include "server/http/header_list.hpp"

namespace leda::server {
namespace {

std::string small(std::string_view text) {
  std::string letters(text);
  for (char& c : letters) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return letters;
}

bool is_json(std::string_view type) {
  return type == "application/json" ||
         (type.starts_with("application/") && type.ends_with("+json"));
}

int exactness(std::string_view range, std::string_view type) {
  if (range == type || (is_json(range) && is_json(type))) return 3;
  if (range == "*/*") return 1;
  const bool whole_kind =
      range.ends_with("/*") && type.starts_with(range.substr(0, range.size() - 1));
  return whole_kind ? 2 : 0;
}

/// q of an entry; 1 where it is not given, 0 where it is no number from 0 to 1.
double quality(std::string_view parameters) {
  while (!parameters.empty()) {
    const std::string parameter = small(take_part(parameters, ';'));
    if (!parameter.starts_with("q=")) continue;
    double q = 0;
    const char* last = parameter.data() + parameter.size();
    const auto [end, error] = std::from_chars(parameter.data() + 2, last, q);
    return error == std::errc{} && end == last && q >= 0 && q <= 1 ? q : 0;
  }
  return 1;
}

}  // namespace

Want wanted(std::string_view accept, std::string_view media_type) {
  if (without_blanks(accept).empty()) return {1, 1};
  Want best;
  while (!accept.empty()) {
    std::string_view entry = take_part(accept, ',');
    const std::string range = small(take_part(entry, ';'));
    const Want found{quality(entry), exactness(range, media_type)};
    const bool fits = found.exactness > best.exactness ||
                      (found.exactness == best.exactness && found.quality > best.quality);
    if (found.exactness > 0 && fits) best = found;
  }
  return best;
}

}  // namespace leda::server
