#pragma once
// A section's result back on the map.

#include <string>

#include "profiles/map/placed_result.hpp"
#include "profiles/map/profile.hpp"
#include "solver/section/section_result.hpp"

namespace leda::profiles {

/// A point of a profile on its trace. x beyond the ends is held at them.
MapPoint point_on_trace(const Profile& profile, double x_m);

/// @param line, order of the section in its layout
/// @param made_by hash of case and program
/// A run that is unstable or interrupted is placed as not known, and says so in its warnings.
PlacedResult place_result(const Profile& profile, int line, double order,
                          const SectionResult& result, const std::string& made_by);

/// A section that screening found stable: known, not moved.
PlacedResult place_stable(const Profile& profile, int line, double order,
                          const std::string& made_by);

/// A section without a result: left out, failed. All its points are the middle of the trace.
PlacedResult place_unknown(const std::string& section, const MapLine& trace, int line, double order,
                           const std::string& reason);

}  // namespace leda::profiles
