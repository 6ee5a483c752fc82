#pragma once
// A section's trace and a DEM to its profile.

#include <variant>

#include "profiles/dem.hpp"
#include "profiles/lay_out_sections.hpp"
#include "profiles/map/profile.hpp"

namespace leda::profiles {

struct TraceOptions {
  double tolerance_m = 0.05;         ///< largest vertical distance of the profile from its samples
  double least_bank_height_m = 2.0;  ///< lower banks are no bank
};

/// Cuts a profile: bilinear samples at no more than half a cell, simplified within the tolerance.
/// Where the trace meets missing data the longest stretch with data and a bank is kept and a
/// warning says so. The ground always spans the profile's own trace, from x = 0.
/// @return the profile, or why there is none
std::variant<Profile, LeftOut> trace_profile(const LaidSection& section, const Dem& dem,
                                             const TraceOptions& options = {});

/// Ground along a trace at every half cell, x in metres from its start; only where there is data.
Polyline sample_ground(const MapLine& trace, const Dem& dem);

/// Keeps the fewest points of a line so that no dropped point lies further than `tolerance_m`
/// above or below it (Douglas and Peucker 1973, with vertical distances).
Polyline simplify(const Polyline& line, double tolerance_m);

}  // namespace leda::profiles
