#include "solver/section/shear_at_rest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/section/overburden.hpp"

namespace leda {
namespace {

constexpr int columns = 40;
constexpr int depths = 24;

/// Calls visit(material, strength, shear, cell) for points that are the middle of as much of the
/// ground as `cell`, m2.
template <class Visit>
void for_each_point(const Section& section, double lower_water_m, const Visit& visit) {
  const double from = section.ground.front().x;
  const double width = section.ground.back().x - from;
  for (int column = 0; column < columns; ++column) {
    const double x = from + width * (column + 0.5) / columns;
    const double ground = elevation_at(section.ground, x);
    const double cell = width / columns * (ground - section.base_m) / depths;
    for (int i = 1; i <= depths; ++i) {
      const double z = ground - (ground - section.base_m) * i / depths;
      const Material& m = section.materials.at(layer_at(section, {x, z + 1e-6}).material);
      const double pore =
          section.water_table ? pore_pressure(section, {x, z + lower_water_m}) : 0.0;
      const double shear =
          0.5 * std::abs(1 - m.k0) * std::max(0.0, overburden(section, {x, z}) - pore);
      visit(m, m.peak_strength.at(ground - z, z), shear, cell);
    }
  }
}

}  // namespace

std::optional<double> factor_at_rest(const Section& section, double lower_water_m) {
  double least = std::numeric_limits<double>::infinity();
  for_each_point(section, lower_water_m,
                 [&](const Material& m, double strength, double shear, double /*cell*/) {
                   if (m.softening && shear > 0) least = std::min(least, strength / shear);
                 });
  if (!std::isfinite(least)) return std::nullopt;
  return least;
}

double share_beyond_strength_at_rest(const Section& section) {
  double all = 0, beyond = 0;
  for_each_point(section, 0, [&](const Material& m, double strength, double shear, double cell) {
    all += cell;
    if (!m.drains && shear > strength) beyond += cell;
  });
  return all > 0 ? beyond / all : 0;
}

}  // namespace leda
