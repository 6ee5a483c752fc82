#include "solver/screening/weak_ground.hpp"

#include <algorithm>
#include <cmath>

#include "solver/section/fault_list.hpp"

namespace leda::solver {
namespace {

constexpr double fractile_5 = -1.6448536269514722;  // of the standard normal distribution

double weak_factor(const RandomField& field) { return factor_at(field, fractile_5); }

void weaken(Strength& strength, double factor) {
  strength.constant_Pa *= factor;
  for (auto& row : strength.table) row[1] *= factor;
}

}  // namespace

std::optional<Section> weak_ground(const Section& section) {
  if (std::ranges::none_of(section.materials,
                           [](const auto& m) { return m.second.field.has_value(); })) {
    return std::nullopt;
  }
  Section weak = section;
  for (auto& [name, m] : weak.materials) {
    if (m.field) weaken(m.peak_strength, weak_factor(*m.field));
    m.field.reset();
  }
  return weak;
}

std::string told_of_weak_ground(const Section& section) {
  std::string told;
  for (const auto& [name, m] : section.materials) {
    if (!m.field) continue;
    told += told.empty()
                ? "strength varies within the ground: factors are those of its 5 % fractile, "
                : ", ";
    told += name + " " + show(std::round(weak_factor(*m.field) * 100) / 100) + " of its mean";
  }
  return told;
}

}  // namespace leda::solver
