#pragma once
// The probability that ground is reached, as a raster: burned from nested zones, so that a contour
// of it is a zone.

#include <filesystem>
#include <string>
#include <vector>

#include "profiles/map/zone.hpp"

namespace leda::profiles {

struct ProbabilityRaster {
  ZoneKind kind = ZoneKind::release;
  int epsg = 0;
  double cell = 0;                     ///< units of the CRS
  std::vector<MapPolygon> spoken_for;  ///< beyond it no section says anything
  /// Of this kind, by growing exceedance; each cell has the largest whose zone holds its middle.
  std::vector<Zone> zones;
  std::string description;
};

/// Cells a raster may have.
inline constexpr double most_raster_cells = 4e8;

/// One band, Float32 from 0 (never reached) to 1, -9999 where no section speaks for the ground, as
/// a Cloud Optimized GeoTIFF; and `file` with the ending .qml, its style for QGIS. The same zones
/// give the same bytes. Each is written under a temporary name, then renamed.
/// @throws ExportError naming the file, also where it would have too many cells
void write_probability_raster(const ProbabilityRaster& raster, const std::filesystem::path& file);

}  // namespace leda::profiles
