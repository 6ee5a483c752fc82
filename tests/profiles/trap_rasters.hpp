#pragma once
// Rasters as other projects keep them for their own tests: what real files get wrong.

#include <filesystem>

namespace leda::test {

/// Writes them into a folder: none of them can be registered as it is.
///   engineering_90m.tif   a CRS that lies nowhere on the ground, cells that are not square
///   gully.asc             no CRS, 28 % of its cells hold data, the rest is 0 (NODATA 0)
///   degrees.asc           no CRS, coordinates in degrees
///   sieve.asc             no CRS, holes of NODATA 999, 74 % of its cells hold data
///   rotated.tif           no CRS, a rotated grid
///   south_up.tif          no CRS, rows from south to north, NODATA is not a number
///   four_bands.tif        UTM, four bands and nothing in any of them
void write_trap_rasters(const std::filesystem::path& folder);

}  // namespace leda::test
