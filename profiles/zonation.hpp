#pragma once
// Placed results to release and runout zones.

#include <vector>

#include "profiles/map/placed_result.hpp"
#include "profiles/map/zone.hpp"

namespace leda::profiles {

struct ZonationOptions {
  double metres_per_unit = 1;  ///< of the CRS
  double strip_width_m = 20;   ///< of the zone of a section that has no neighbours
};

/// Release zones lie between backscarps and toes, runout zones between toes and fronts.
/// Neighbours (same line, next in order) that both moved, and to the same side, are joined. Towards
/// a stable neighbour the zone closes to nothing half-way; towards one without a result it ends
/// half-way at full length and carries a warning. The first and last section of a line reach half a
/// spacing beyond. A named section gets a strip of `strip_width_m`. Zones are valid multipolygons,
/// also where sections cross; one chain of joined sections gives at most one zone of each kind.
/// @throws std::runtime_error where GEOS fails
std::vector<Zone> make_zones(const std::vector<PlacedResult>& results,
                             const ZonationOptions& options = {});

}  // namespace leda::profiles
