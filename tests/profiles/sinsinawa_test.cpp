// Real terrain: a river valley with surveyed points (tests/data/sinsinawa), in feet and in metres.

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "profiles/dem.hpp"
#include "tests/profiles/drawn_dem.hpp"
#include "tests/verification/record.hpp"

namespace leda::profiles {
namespace {

namespace fs = std::filesystem;

constexpr double metres_in_a_foot = 0.3048;

struct Surveyed {
  MapPoint at;
  double elevation_ft = 0;
};

std::vector<Surveyed> surveyed_points() {
  std::ifstream file(fs::path(LEDA_TEST_DATA) / "sinsinawa" / "points.csv");
  std::string header;
  std::getline(file, header);
  std::vector<Surveyed> points;
  Surveyed p;
  char comma = 0;
  while (file >> p.at.x >> comma >> p.at.y >> comma >> p.elevation_ft) points.push_back(p);
  return points;
}

fs::path dem_in_feet() { return fs::path(LEDA_TEST_DATA) / "sinsinawa" / "dem_2m_feet.tif"; }

Dem open_in_feet() {
  return Dem::open(dem_in_feet(), {.vertical_unit = "ft", .epsg = 0, .limits = {}});
}

TEST(Sinsinawa, BilinearSamplesAgreeWithTheSurveyedPoints) {
  const Dem dem = open_in_feet();
  double squares = 0;
  const auto points = surveyed_points();
  ASSERT_EQ(points.size(), 3522U);
  for (const Surveyed& point : points) {
    const auto z = dem.sample(point.at);
    ASSERT_TRUE(z) << point.at.x << " " << point.at.y;
    const double off_feet = *z / metres_in_a_foot - point.elevation_ft;
    squares += off_feet * off_feet;
  }
  const double rmse_feet = std::sqrt(squares / static_cast<double>(points.size()));
  leda::test::record(rmse_feet, " ft over ", points.size(), " points");
  EXPECT_LE(rmse_feet, 0.20);
}

/// The same ground with elevations in metres, converted here and by nobody else.
fs::path write_in_metres(const fs::path& file) {
  initialize_gdal();
  const GDALDatasetUniquePtr feet(GDALDataset::Open(dem_in_feet().c_str()));
  test::DrawnDem dem;
  dem.columns = feet->GetRasterXSize();
  dem.rows = feet->GetRasterYSize();
  feet->GetGeoTransform(dem.transform.data());
  dem.epsg = 26915;
  dem.cells.resize(static_cast<std::size_t>(dem.columns) * static_cast<std::size_t>(dem.rows));
  EXPECT_EQ(feet->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, dem.columns, dem.rows, dem.cells.data(),
                                             dem.columns, dem.rows, GDT_Float32, 0, 0, nullptr),
            CE_None);
  for (float& z : dem.cells) {
    if (z > -9999) z = static_cast<float>(z * metres_in_a_foot);
  }
  return test::write_geotiff(dem, file);
}

TEST(Sinsinawa, FeetAndMetresAreTheSameGround) {
  const test::TestFolder folder;
  const Dem feet = open_in_feet();
  const Dem metres = Dem::open(write_in_metres(folder / "metres.tif"));
  for (const Surveyed& point : surveyed_points()) {
    const auto a = feet.sample(point.at), b = metres.sample(point.at);
    ASSERT_TRUE(a && b) << point.at.x << " " << point.at.y;
    EXPECT_NEAR(*a, *b, 0.002);
  }
}

}  // namespace
}  // namespace leda::profiles
