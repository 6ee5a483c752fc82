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

std::size_t layer_lists(const Section& section) {
  return std::max<std::size_t>(1, section.columns.size());
}

const std::vector<Layer>& layers_of(const Section& section, std::size_t list) {
  return section.columns.empty() ? section.layers : section.columns[list].layers;
}

std::size_t layer_list_at(const Section& section, double x) {
  std::size_t list = 0;
  while (list + 1 < section.columns.size() && x >= section.columns[list].to_m) ++list;
  return list;
}

const std::vector<Layer>& layers_at(const Section& section, double x) {
  return layers_of(section, layer_list_at(section, x));
}

double layer_bottom(const Section& section, const Layer& layer, double x) {
  const double ground = std::max(elevation_at(section.ground, x), section.base_m);
  return std::clamp(stated_bottom(section, layer, x), section.base_m, ground);
}

const Layer& layer_at(const Section& section, Point p) {
  const std::vector<Layer>& layers = layers_at(section, p.x);
  for (std::size_t i = 0; i + 1 < layers.size(); ++i) {
    if (p.z >= layer_bottom(section, layers[i], p.x)) return layers[i];
  }
  return layers.back();
}

double pore_pressure(const Section& section, Point p) {
  if (!section.water_table) return 0;
  const WaterTable& water = *section.water_table;
  const double level = water.depth_m ? elevation_at(section.ground, p.x) - *water.depth_m
                                     : elevation_at(water.line, p.x);
  return std::max(0.0, (level - p.z) * water_unit_weight);
}

}  // namespace leda
