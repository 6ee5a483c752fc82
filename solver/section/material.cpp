#include "solver/section/material.hpp"

#include <algorithm>

namespace leda {
namespace {

double strength_of(const std::array<double, 2>& row) { return row[1]; }

/// Straight between the rows; the first and the last value are held beyond them.
double interpolate(const std::vector<std::array<double, 2>>& table, double at) {
  const auto next = std::upper_bound(table.begin(), table.end(), at,
                                     [](double v, const auto& row) { return v < row[0]; });
  if (next == table.begin()) return next->at(1);
  if (next == table.end()) return table.back()[1];
  const auto& [a, strength_a] = *(next - 1);
  const auto& [b, strength_b] = *next;
  return strength_a + (strength_b - strength_a) * ((at - a) / (b - a));
}

}  // namespace

double Strength::at(double depth_m, double elevation_m) const {
  if (by == By::constant) return constant_Pa;
  return interpolate(table, by == By::depth ? depth_m : elevation_m);
}

double Strength::smallest() const {
  if (by == By::constant) return constant_Pa;
  return std::ranges::min(table, {}, strength_of)[1];
}

double Strength::largest() const {
  if (by == By::constant) return constant_Pa;
  return std::ranges::max(table, {}, strength_of)[1];
}

double Material::remolded_strength_Pa() const {
  if (!softening) return 0;
  if (const auto* dey = std::get_if<DeySoftening>(&softening->law)) {
    return dey->large_strain_strength_Pa;
  }
  return std::visit([](const auto& law) { return law.remolded_strength_Pa; }, softening->law);
}

}  // namespace leda
