#pragma once
// Lines and areas that cross 180 degrees, cut in two there as RFC 7946 (3.1.9) asks for.

#include <vector>

#include "profiles/map/coordinates.hpp"

namespace leda::profiles {

/// Longitudes without the jump from 180 to -180: they run on beyond.
MapLine unwrapped(MapLine degrees);

/// The parts of a line on either side of 180 degrees, in their order; most have one.
std::vector<MapLine> cut_at_antimeridian(const MapLine& degrees);
/// Likewise of an area; rings keep the sense they turn in.
std::vector<MapPolygon> cut_at_antimeridian(const MapPolygon& degrees);

/// West is greater than east where the points lie on both sides of 180 degrees.
/// @pre at least one point
MapBox box_around(const MapLine& degrees);

}  // namespace leda::profiles
