#include "solver/screening/shear_at_rest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace leda::solver {
namespace {

constexpr int columns = 40;
constexpr int depths = 24;

double total_stress(const Section& section, double x, double ground, double z) {
  double stress = 0;
  double top = ground;
  for (const Layer& layer : layers_at(section, x)) {
    if (top <= z) break;
    const double bottom = std::max(z, layer_bottom(section, layer, x));
    if (bottom >= top) continue;
    stress += section.materials.at(layer.material).unit_weight * (top - bottom);
    top = bottom;
  }
  return stress;
}

/// Least factor on one vertical; infinity where nothing softens there.
double least_in_column(const Section& section, double x, double lower_water_m) {
  double least = std::numeric_limits<double>::infinity();
  const double ground = elevation_at(section.ground, x);
  for (int i = 1; i <= depths; ++i) {
    const double z = ground - (ground - section.base_m) * i / depths;
    const Material& m = section.materials.at(layer_at(section, {x, z + 1e-6}).material);
    if (!m.softening) continue;
    const double pore = section.water_table ? pore_pressure(section, {x, z + lower_water_m}) : 0.0;
    const double shear =
        0.5 * std::abs(1 - m.k0) * std::max(0.0, total_stress(section, x, ground, z) - pore);
    if (shear > 0) least = std::min(least, m.peak_strength.at(ground - z, z) / shear);
  }
  return least;
}

}  // namespace

std::optional<double> factor_at_rest(const Section& section, double lower_water_m) {
  const double from = section.ground.front().x;
  const double width = section.ground.back().x - from;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < columns; ++i) {
    const double x = from + width * (i + 0.5) / columns;
    least = std::min(least, least_in_column(section, x, lower_water_m));
  }
  if (!std::isfinite(least)) return std::nullopt;
  return least;
}

}  // namespace leda::solver
