#pragma once
// The ground under a region: layers and materials, and where on the map they apply.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "profiles/map/coordinates.hpp"
#include "solver/section/section.hpp"

namespace leda {

struct SoilModel {
  std::string name;
  std::vector<Layer> layers;  ///< top down
  std::map<std::string, Material> materials;
  std::optional<WaterTable> water_table;  ///< a line is not allowed here: depth only
  std::optional<double> base_m;           ///< elevation of the model's base
  /// Used where base_m is absent: below the toe, or below the lowest ground where that is lower.
  double base_below_toe_m = 5;
  std::vector<MapPolygon> where;  ///< empty: everywhere no other model applies
};

}  // namespace leda
