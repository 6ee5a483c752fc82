#pragma once
// Stations and sides of the sections laid along a line.

#include <vector>

#include "profiles/dem.hpp"
#include "profiles/lay_out_sections.hpp"
#include "profiles/map/section_layout.hpp"

namespace leda::profiles {

/// How many sections a spacing gives on a line of that length; lengths in the same unit.
double count_along(double length, double spacing);

/// A line smoothed by a moving mean over two spacings (the window shrinks towards the ends, which
/// stay where they are).
MapLine smoothed(const MapLine& line, double spacing);

/// @param line_index the number its sections carry in `line`
/// @param first the number of the first section: 1 gives S001
/// @pre the layout has no faults
std::vector<LaidSection> lay_along(const SectionsAlong& along, int line_index, int first,
                                   const Dem& dem);

}  // namespace leda::profiles
