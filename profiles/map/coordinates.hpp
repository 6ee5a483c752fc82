#pragma once
// Points, lines and areas of the map, in the DEM's coordinate reference system.

#include <array>
#include <vector>

namespace leda {

struct MapPoint {
  double x = 0;  ///< easting, units of the CRS
  double y = 0;  ///< northing, units of the CRS
  friend bool operator==(const MapPoint&, const MapPoint&) = default;
};

using MapLine = std::vector<MapPoint>;

struct MapPolygon {
  MapLine outer;               ///< closed: first point repeated at the end
  std::vector<MapLine> holes;  ///< closed
};

/// {west, south, east, north}
using MapBox = std::array<double, 4>;

}  // namespace leda
