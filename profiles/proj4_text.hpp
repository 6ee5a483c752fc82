#pragma once
// A coordinate system as other programs know it.

#include <string>

namespace leda::profiles {

/// The CRS of an EPSG code in PROJ's older text form, "+proj=tmerc +lat_0=0 ...", which programs
/// without PROJ's database read. Empty where it has none.
std::string proj4_text(int epsg);

}  // namespace leda::profiles
