#pragma once
// What the members of a region's sections say, for the map.

#include <vector>

#include "db/store.hpp"
#include "profiles/probability_zones.hpp"
#include "server/documents/region_request.hpp"

namespace leda::server {

/// One a section, with its distances at each exceedance. Where the first look is not over, or the
/// section was left out, with the reason.
std::vector<profiles::SectionQuantiles> region_quantiles(
    const db::Store& store, const Ensemble& ensemble, const std::vector<SoilModel>& soil,
    const std::vector<db::SectionRecord>& sections, const std::vector<double>& exceedance);

}  // namespace leda::server
