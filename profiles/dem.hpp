#pragma once
// A digital elevation model: opened safely, read in windows, sampled in metres.

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "profiles/map/coordinates.hpp"

namespace leda::profiles {

/// A raster that can't serve as a DEM. The message says what is wrong and what to do about it.
class DemError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What one raster may cost. A small file can declare a huge grid, so this is checked first.
struct DemLimits {
  std::int64_t most_bytes = std::int64_t{8} << 30;  ///< cells x bands x bytes a cell, unpacked
};

struct DemOptions {
  std::string vertical_unit;  ///< "m", "ft", "us-ft"; empty: as the file says; wins over the file
  int epsg = 0;               ///< for files that carry no CRS; 0: as the file says
  std::optional<double> nodata{};     ///< the value of missing cells, as stored; wins over the file
  std::optional<double> missing_m{};  ///< cells of this elevation count as missing too
  DemLimits limits;
};

struct DemInfo {
  int epsg = 0;  ///< of the horizontal CRS
  std::string crs_name;
  double metres_per_unit = 1;     ///< horizontal: one unit of the CRS in metres
  double cell_x = 0, cell_y = 0;  ///< units of the CRS, positive
  int width = 0, height = 0;      ///< cells
  MapBox box{};                   ///< of all four corners
  std::string vertical_unit;      ///< "m", "ft" or "us-ft"
  double metres_per_vertical_unit = 1;
  std::optional<double> missing_m;  ///< as the options say: cells of this elevation are missing
  bool rotated = false;             ///< rows do not run west to east

  /// The smaller side of a cell in metres.
  double cell_m() const;
};

/// For messages about missing data: ". Cells of exactly 0 m count as missing ..."; else empty.
std::string note_on_missing(const DemInfo& info);

/// Prepares GDAL for hostile input: only the drivers Leda needs, no network, no side files.
/// Called by everything here that uses GDAL; calling it again does nothing.
void initialize_gdal();

/// An open DEM. Movable, not copyable; one thread at a time (reading fills a cache).
class Dem {
 public:
  /// Opens a GeoTIFF, COG or Arc ASCII grid of one band in a projected CRS.
  /// @throws DemError where it is none of these: no CRS, degrees, unknown units, several bands,
  ///         too large, not readable
  static Dem open(const std::filesystem::path& file, const DemOptions& options = {});
  ~Dem();
  Dem(const Dem&) = delete;
  Dem& operator=(const Dem&) = delete;
  Dem(Dem&& other) noexcept;
  Dem& operator=(Dem&& other) noexcept;

  const DemInfo& info() const;

  /// Ground elevation by bilinear interpolation between the four nearest cell centres, m.
  /// In the outer half cell the nearest centres are used. Nothing outside the DEM, and nothing
  /// where a cell that takes part holds no data.
  /// @throws DemError where the file can't be read
  std::optional<double> sample(MapPoint p) const;

  /// Whether a point lies on the grid, with or without data.
  bool contains(MapPoint p) const;

  /// A window of cells, row by row, in metres, NaN where there is no data.
  /// @param width, height of the window, cells; it must lie within the DEM
  /// @param columns, rows of the answer: fewer than the window gives averages
  std::vector<float> read(int column, int row, int width, int height, int columns, int rows) const;

  /// The point of the map at a position on the grid; (0, 0) is the outer corner of the first cell.
  MapPoint to_map(double column, double row) const;
  /// The position on the grid of a point of the map, {column, row}.
  std::array<double, 2> to_grid(MapPoint p) const;

 private:
  struct Raster;
  explicit Dem(std::unique_ptr<Raster> raster);
  std::unique_ptr<Raster> raster_;
};

}  // namespace leda::profiles
