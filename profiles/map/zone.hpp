#pragma once
// Release and runout zones: the product.

#include <string>
#include <vector>

#include "profiles/map/coordinates.hpp"
#include "solver/section/section_result.hpp"

namespace leda {

enum class ZoneKind { release, runout };

struct Zone {
  ZoneKind kind = ZoneKind::release;
  std::vector<MapPolygon> area;       ///< a valid multipolygon
  std::vector<std::string> sections;  ///< whose results made it
  double largest_distance_m = 0;      ///< retrogression, or runout
  double mean_distance_m = 0;
  Bound distance_is = Bound::measured;  ///< a lower bound where one of its sections has one
  std::vector<std::string> warnings;
  std::string made_by;  ///< sha256 over what made it
};

}  // namespace leda
