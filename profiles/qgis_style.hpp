#pragma once
// How the layers look in QGIS: styles (QML) that a GeoPackage carries with it.

#include <string>
#include <vector>

#include "profiles/map/zone.hpp"

namespace leda::profiles {

/// @param layer "sections", "profiles", "release_zones", "runout_zones" or "probability_zones"
/// @param zones whose probabilities the legend names
/// @return a QML document for QGIS 3; empty for any other layer
std::string qgis_style(const std::string& layer, const std::vector<Zone>& zones);

/// Of a raster of probabilities from 0 to 1.
std::string qgis_raster_style(ZoneKind kind);

}  // namespace leda::profiles
