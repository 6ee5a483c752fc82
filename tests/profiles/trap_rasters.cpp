#include "tests/profiles/trap_rasters.hpp"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>

#include "tests/profiles/drawn_dem.hpp"

namespace leda::test {
namespace {

struct AsciiGrid {
  int columns = 0, rows = 0;
  double west = 0, south = 0, cell = 1;
  int nodata = -32768;
};

/// `elevation` of column and row, or nodata.
void write_ascii(const std::filesystem::path& file, const AsciiGrid& grid,
                 const std::function<double(int, int)>& elevation) {
  std::ofstream out(file);
  out.precision(12);
  out << "ncols " << grid.columns << "\nnrows " << grid.rows << "\nxllcorner " << grid.west
      << "\nyllcorner " << grid.south << "\ncellsize " << grid.cell << "\nNODATA_value "
      << grid.nodata << "\n";
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) out << elevation(column, row) << " ";
    out << "\n";
  }
}

DrawnDem plain(int columns, int rows, const std::array<double, 6>& transform) {
  DrawnDem dem = computed(columns, rows, transform, [](MapPoint) { return 12.5; });
  dem.epsg = 0;
  return dem;
}

void write_engineering(const std::filesystem::path& file) {
  write_geotiff(plain(23, 18, {664692, 89.983, 0, 4895827, 0, -90.022}), file);
  OGRSpatialReference nowhere;
  nowhere.SetLocalCS("unnamed");
  const GDALDatasetUniquePtr dataset(GDALDataset::Open(file.c_str(), GDAL_OF_UPDATE));
  dataset->SetSpatialRef(&nowhere);
}

}  // namespace

void write_trap_rasters(const std::filesystem::path& folder) {
  write_ascii(folder / "gully.asc", {50, 80, 559705, 4380220, 3, 0},
              [](int column, int) { return column < 14 ? 1770.0 + column : 0.0; });
  write_ascii(folder / "degrees.asc", {30, 20, -104.341805555546, 39.505972222219, 0.000277777778},
              [](int column, int row) { return 1771 + column + row; });
  write_ascii(folder / "sieve.asc", {50, 60, 0, 0, 2, 999},
              [](int column, int) { return column < 37 ? 7.25 + 0.1 * column : 999.0; });
  const double angle = std::acos(-1.0) / 6;
  write_geotiff(plain(10, 15,
                      {100, 20 * std::cos(angle), 10 * std::sin(angle), 200, 20 * std::sin(angle),
                       -10 * std::cos(angle)}),
                folder / "rotated.tif");
  DrawnDem south_up = plain(3, 2, {0, 100, 0, 0, 0, 100});
  south_up.nodata = std::numeric_limits<double>::quiet_NaN();
  south_up.cells[4] = std::numeric_limits<float>::quiet_NaN();
  write_geotiff(south_up, folder / "south_up.tif");
  DrawnDem four_bands = drawn({"...", "..."}, 1, 3);
  four_bands.epsg = 32628;
  four_bands.bands = 4;
  write_geotiff(four_bands, folder / "four_bands.tif");
  write_engineering(folder / "engineering_90m.tif");
}

}  // namespace leda::test
