#pragma once
// How the layers look in QGIS: styles (QML) that a GeoPackage carries with it.

#include <string>

namespace leda::profiles {

/// @param layer "sections", "profiles", "release_zones" or "runout_zones"
/// @return a QML document for QGIS 3; empty for any other layer
std::string qgis_style(const std::string& layer);

}  // namespace leda::profiles
