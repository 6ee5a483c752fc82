#include "solver/section/strength_extremes.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace leda {
namespace {

using Table = std::vector<std::array<double, 2>>;

/// Where the strength leaves the range of an extreme for good, and to which side.
struct Leaving {
  double at = 0;
  bool upwards = false;
};

/// Goes from row to row, `step` being 1 or -1, until a strength is beyond `least` or `most`.
std::optional<Leaving> leaving(const Table& table, std::size_t from, int step, double least,
                               double most) {
  const auto last = step > 0 ? table.size() - 1 : 0;
  for (std::size_t i = from; i != last; i += static_cast<std::size_t>(step)) {
    const auto& [a, strength_a] = table[i];
    const auto& [b, strength_b] = table[i + static_cast<std::size_t>(step)];
    if (strength_b >= least && strength_b <= most) continue;
    const double limit = strength_b > most ? most : least;
    return Leaving{a + (b - a) * ((limit - strength_a) / (strength_b - strength_a)),
                   strength_b > most};
  }
  return std::nullopt;
}

}  // namespace

std::vector<StrengthExtreme> extremes_of(const Strength& strength) {
  std::vector<StrengthExtreme> found;
  const Table& table = strength.table;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto [place, value] = table[i];
    const double least = value * (1 - share_of_extreme), most = value * (1 + share_of_extreme);
    const auto before = leaving(table, i, -1, least, most);
    const auto after = leaving(table, i, 1, least, most);
    if (!before || !after || before->upwards != after->upwards) continue;
    StrengthExtreme one{value, before->upwards, before->at, after->at, place, place};
    bool is_extreme = true;
    for (const auto& [other, its_value] : table) {
      if (other < one.from || other > one.to) continue;
      is_extreme = is_extreme && (one.is_dip ? its_value >= value : its_value <= value);
      if (its_value != value) continue;
      one.core_from = std::min(one.core_from, other);
      one.core_to = std::max(one.core_to, other);
    }
    // Of rows with the same strength the first stands for all.
    if (is_extreme && one.core_from == place) found.push_back(one);
  }
  return found;
}

}  // namespace leda
