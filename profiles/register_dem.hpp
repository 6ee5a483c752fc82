#pragma once
// Takes a raster from outside into the data folder: checked whole, written anew.

#include <cstdint>
#include <filesystem>
#include <string>

#include "profiles/dem.hpp"

namespace leda::profiles {

struct RegisteredDem {
  DemInfo info;        ///< of the new file
  std::string sha256;  ///< of the new file
  std::int64_t bytes = 0;
  double lowest_m = 0, highest_m = 0;  ///< ground elevation
  double share_with_data = 0;          ///< of all cells, 0 to 1
};

/// Reads every cell of `input` and writes a Cloud Optimized GeoTIFF of float elevations in the
/// input's own vertical unit, which it names; under a temporary name, then renamed.
/// The same input and options give the same bytes.
/// @throws DemError as Dem::open does, and where no cell holds data or the elevations are not
///         those of ground (below -500 m or above 9000 m); `output` is then not touched
RegisteredDem register_dem(const std::filesystem::path& input, const std::filesystem::path& output,
                           const DemOptions& options = {});

}  // namespace leda::profiles
