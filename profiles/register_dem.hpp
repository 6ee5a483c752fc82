#pragma once
// Takes a raster from outside into the data folder: checked whole, written anew.

#include <cstdint>
#include <filesystem>
#include <string>

#include "profiles/dem.hpp"
#include "profiles/undeclared_fill.hpp"

namespace leda::profiles {

struct RegisteredDem {
  DemInfo info;        ///< of the new file
  std::string sha256;  ///< of the new file
  std::int64_t bytes = 0;
  double lowest_m = 0, highest_m = 0;                  ///< ground elevation
  double share_with_data = 0;                          ///< of all cells, 0 to 1
  std::optional<std::array<double, 2>> cell_ground_m;  ///< a cell at the middle, on the ground
  std::optional<UndeclaredFill> fill;                  ///< cells that are to count as missing
  std::vector<std::string> warnings;
};

/// What a raster's own word on missing cells is worth.
enum class Fills {
  look_for,    ///< a value that fills whole pieces counts as missing, with a warning
  all_ground,  ///< somebody said that every value is ground
};

/// Reads every cell of `input` and writes a Cloud Optimized GeoTIFF of float elevations in the
/// input's own vertical unit, which it names; under a temporary name, then renamed: it is on the
/// disk when this returns. The same input and options give the same bytes. Warns of an undeclared
/// fill, and where a metre of the map is none on the ground.
/// @throws DemError as Dem::open does, where the map is stretched by more than 1 % everywhere (see
///         ground_scale.hpp), and where no cell holds data or the elevations are not
///         those of ground (below -500 m or above 9000 m); `output` is then not touched
RegisteredDem register_dem(const std::filesystem::path& input, const std::filesystem::path& output,
                           const DemOptions& options = {}, Fills fills = Fills::look_for);

}  // namespace leda::profiles
