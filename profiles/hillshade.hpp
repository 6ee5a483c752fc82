#pragma once
// A shaded picture of the ground, and of zones over it.

#include <filesystem>
#include <optional>
#include <vector>

#include "profiles/dem.hpp"
#include "profiles/map/zone.hpp"

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

/// Writes a grey PNG with transparency where there is no data (slope and aspect after Horn 1981),
/// under a temporary name, then renamed.
/// @throws DemError where the window misses the DEM or the file can't be written
Picture write_hillshade(const Dem& dem, const std::filesystem::path& png,
                        const HillshadeOptions& options = {});

/// The same with release zones in red, runout zones in orange and lines in blue over it.
Picture write_zone_picture(const Dem& dem, const std::vector<Zone>& zones,
                           const std::vector<MapLine>& lines, const std::filesystem::path& png,
                           const HillshadeOptions& options = {});

}  // namespace leda::profiles
