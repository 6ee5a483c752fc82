#pragma once
// Lengths, positions and crossings of lines on the map, in units of the CRS.

#include <optional>

#include "profiles/map/coordinates.hpp"

namespace leda::profiles {

double distance(MapPoint a, MapPoint b);
double length_of(const MapLine& line);

/// The point at a distance along a line; beyond the ends it is held.
MapPoint point_at(const MapLine& line, double along);

/// The piece of a line between two distances along it, from < to.
MapLine piece_of(const MapLine& line, double from, double to);

struct Nearest {
  double along = 0;     ///< distance along the line of its point nearest to p
  double distance = 0;  ///< from p to that point
};
Nearest nearest_on(const MapLine& line, MapPoint p);

/// Where a line first crosses or touches itself; a closed ring does not by being closed.
std::optional<MapPoint> first_self_crossing(const MapLine& line);

/// The greatest angle between a piece of a line and the straight way between its ends, degrees,
/// and where that piece begins. Pieces shorter than a hundredth of the line do not count.
struct Bend {
  double degrees = 0;
  MapPoint at;
};
/// @pre the ends differ
Bend greatest_bend(const MapLine& line);

/// Even-odd rule, with holes.
bool is_inside(const MapPolygon& polygon, MapPoint p);

}  // namespace leda::profiles
