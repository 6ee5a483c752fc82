#include "solver/section/section.hpp"

#include <algorithm>

#include "solver/section/crest_and_toe.hpp"

namespace leda {
namespace {

/// Elevation that depths below the toe are measured from: the toe given, the toe found, or the
/// lowest ground where the ground has no bank.
double toe_elevation(const Section& section) {
  if (section.toe) return section.toe->z;
  if (const auto bank = find_crest_and_toe(section.ground)) return bank->toe.z;
  return std::ranges::min(section.ground, {}, &Point::z).z;
}

double stated_bottom(const Section& section, const Layer& layer, double x) {
  if (layer.thickness_m) return elevation_at(section.ground, x) - *layer.thickness_m;
  if (layer.bottom_m) return *layer.bottom_m;
  if (layer.bottom_below_toe_m) return toe_elevation(section) - *layer.bottom_below_toe_m;
  if (!layer.bottom.empty()) return elevation_at(layer.bottom, x);
  return section.base_m;
}

}  // namespace

double layer_bottom(const Section& section, std::size_t layer, double x) {
  const double ground = std::max(elevation_at(section.ground, x), section.base_m);
  return std::clamp(stated_bottom(section, section.layers[layer], x), section.base_m, ground);
}

std::size_t layer_at(const Section& section, Point p) {
  for (std::size_t i = 0; i + 1 < section.layers.size(); ++i) {
    if (p.z >= layer_bottom(section, i, p.x)) return i;
  }
  return section.layers.size() - 1;
}

double pore_pressure(const Section& section, Point p) {
  if (!section.water_table) return 0;
  const WaterTable& water = *section.water_table;
  const double level = water.depth_m ? elevation_at(section.ground, p.x) - *water.depth_m
                                     : elevation_at(water.line, p.x);
  return std::max(0.0, (level - p.z) * water_unit_weight);
}

}  // namespace leda
