#pragma once
// A shaded picture of the ground.

#include <filesystem>
#include <optional>

#include "profiles/dem.hpp"

namespace leda::profiles {

struct HillshadeOptions {
  std::optional<MapBox> window;  ///< absent: the whole DEM
  int most_pixels = 1600;        ///< of the longer side
  double azimuth_deg = 315;      ///< of the light, clockwise from north
  double altitude_deg = 45;      ///< of the light, above the horizon
  double vertical_exaggeration = 2;
};

/// Where a picture lies on the map: its pixels run along the rows of the DEM's grid.
struct Picture {
  int width = 0, height = 0;
  MapBox box{};  ///< exact for a DEM that is not rotated
};

/// Writes a grey PNG with transparency where there is no data (GDAL's hillshade, after Horn 1981),
/// in a folder of its own beside it, then moved: several may write the same file at once.
/// @throws DemError where the window misses the DEM or the file can't be written
Picture write_hillshade(const Dem& dem, const std::filesystem::path& png,
                        const HillshadeOptions& options = {});

}  // namespace leda::profiles
