#include "tests/profiles/drawn_dem.hpp"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "profiles/dem.hpp"

namespace leda::test {

TestFolder::TestFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "leda-profiles-XXXXXX").string();
  if (!mkdtemp(pattern.data())) throw std::runtime_error("no temporary folder");
  path_ = pattern;
}

TestFolder::~TestFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

DrawnDem drawn(const std::vector<std::string>& rows, double step, double cell) {
  DrawnDem dem;
  dem.rows = static_cast<int>(rows.size());
  dem.columns = static_cast<int>(rows.at(0).size());
  dem.transform = {1000, cell, 0, 2000, 0, -cell};
  for (const std::string& row : rows) {
    for (const char c : row) {
      dem.cells.push_back(c == '.' ? std::numeric_limits<float>::quiet_NaN()
                                   : static_cast<float>((c - '0') * step));
    }
  }
  return dem;
}

DrawnDem computed(int columns, int rows, const std::array<double, 6>& transform,
                  const std::function<double(leda::MapPoint)>& elevation) {
  DrawnDem dem;
  dem.columns = columns;
  dem.rows = rows;
  dem.transform = transform;
  const auto& t = transform;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const double u = c + 0.5, v = r + 0.5;
      dem.cells.push_back(
          static_cast<float>(elevation({t[0] + t[1] * u + t[2] * v, t[3] + t[4] * u + t[5] * v})));
    }
  }
  return dem;
}

std::filesystem::path write_geotiff(const DrawnDem& dem, const std::filesystem::path& file) {
  leda::profiles::initialize_gdal();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  GDALDataset* dataset =
      driver->Create(file.c_str(), dem.columns, dem.rows, dem.bands, GDT_Float32, nullptr);
  if (!dataset) throw std::runtime_error("can't write " + file.string());
  std::array<double, 6> transform = dem.transform;
  dataset->SetGeoTransform(transform.data());
  if (dem.epsg != 0) {
    OGRSpatialReference crs;
    crs.importFromEPSG(dem.epsg);
    dataset->SetSpatialRef(&crs);
  }
  std::vector<float> cells = dem.cells;
  for (float& z : cells) {
    if (std::isnan(z)) z = static_cast<float>(dem.nodata);
  }
  for (int b = 1; b <= dem.bands; ++b) {
    GDALRasterBand* band = dataset->GetRasterBand(b);
    band->SetNoDataValue(dem.nodata);
    if (!dem.vertical_unit.empty()) band->SetUnitType(dem.vertical_unit.c_str());
    const CPLErr result = band->RasterIO(GF_Write, 0, 0, dem.columns, dem.rows, cells.data(),
                                         dem.columns, dem.rows, GDT_Float32, 0, 0, nullptr);
    if (result != CE_None) throw std::runtime_error("can't write " + file.string());
  }
  GDALClose(GDALDataset::ToHandle(dataset));
  return file;
}

}  // namespace leda::test
