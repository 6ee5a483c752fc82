#include "profiles/dbf_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace leda::profiles {

std::string ended_within(const std::string& text, std::size_t most) {
  const std::string mark = "...";
  if (text.size() <= most) return text;
  std::size_t end = most - mark.size();
  // UTF-8: bytes 10xxxxxx go on with the letter before them.
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end) + mark;
}

std::string joined_within(const std::vector<std::string>& items, const std::string& between,
                          std::size_t most) {
  std::string all = fmt::format("{}", fmt::join(items, between));
  if (all.size() <= most) return all;
  const auto rest = [&](std::size_t kept) {
    return fmt::format(" and {} more (see the GeoPackage)", items.size() - kept);
  };
  std::string text;
  std::size_t kept = 0;
  for (; kept < items.size(); ++kept) {
    const std::string longer = text + (kept == 0 ? "" : between) + items[kept];
    if (longer.size() + rest(kept + 1).size() > most) break;
    text = longer;
  }
  if (kept > 0) return text + rest(kept);
  if (items.size() == 1) return ended_within(items[0], most);
  return ended_within(items[0], most - rest(1).size()) + rest(1);
}

}  // namespace leda::profiles
