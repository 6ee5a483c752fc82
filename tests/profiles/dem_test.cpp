#include "profiles/dem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "tests/profiles/drawn_dem.hpp"

namespace leda::profiles {
namespace {

using test::computed;
using test::drawn;
using test::TestFolder;
using test::write_geotiff;

constexpr double pi = 3.14159265358979323846;

TEST(Dem, SaysWhereItLiesAndInWhichUnits) {
  const TestFolder folder;
  const Dem dem = Dem::open(write_geotiff(drawn({"123", "456"}, 1, 2), folder / "dem.tif"));
  EXPECT_EQ(dem.info().epsg, 2950);
  EXPECT_EQ(dem.info().width, 3);
  EXPECT_EQ(dem.info().height, 2);
  EXPECT_DOUBLE_EQ(dem.info().cell_x, 2);
  EXPECT_DOUBLE_EQ(dem.info().cell_m(), 2);
  EXPECT_EQ(dem.info().box, (MapBox{1000, 1996, 1006, 2000}));
  EXPECT_EQ(dem.info().vertical_unit, "m");
  EXPECT_FALSE(dem.info().rotated);
}

TEST(Dem, SamplesBilinearlyBetweenCellCentres) {
  const TestFolder folder;
  const Dem dem = Dem::open(write_geotiff(drawn({"13", "57"}), folder / "dem.tif"));
  EXPECT_DOUBLE_EQ(dem.sample({1000.5, 1999.5}).value(), 1);
  EXPECT_DOUBLE_EQ(dem.sample({1001.0, 1999.0}).value(), 4);
  EXPECT_DOUBLE_EQ(dem.sample({1000.75, 1999.5}).value(), 1.5);
  EXPECT_DOUBLE_EQ(dem.sample({1000.0, 2000.0}).value(), 1);  // the outer half cell
  EXPECT_FALSE(dem.sample({999.9, 1999.5}));
  EXPECT_FALSE(dem.sample({std::nan(""), 1999.5}));
}

// Cells of 1.5 m have no exact inverse: corners come back a rounding error beyond the grid.
TEST(Dem, ThePointsOfItsOwnBoxLieOnIt) {
  for (const double cell : {0.3, 0.7, 0.9, 1.5, 3.3, 0.3048}) {
    const TestFolder folder;
    const auto grid = computed(187, 133, {380000, cell, 0, 5113199.5, 0, -cell},
                               [](MapPoint p) { return 1e-3 * (p.x - 380000); });
    const Dem dem = Dem::open(write_geotiff(grid, folder / "dem.tif"));
    const MapBox& box = dem.info().box;
    for (const double x : {box[0], (box[0] + box[2]) / 2, box[2]}) {
      for (const double y : {box[1], (box[1] + box[3]) / 2, box[3]}) {
        EXPECT_TRUE(dem.contains({x, y})) << cell << " m: " << x << " " << y;
        EXPECT_TRUE(dem.sample({x, y})) << cell << " m: " << x << " " << y;
      }
    }
    EXPECT_TRUE(dem.contains({box[0] - 1e-9, box[3] + 1e-9})) << "noise of clipping";
    EXPECT_FALSE(dem.contains({box[0] - 0.01 * cell, box[1]}));
    EXPECT_FALSE(dem.contains({box[0], box[3] + 0.01 * cell}));
  }
}

TEST(Dem, ASampleNextToMissingDataIsMissing) {
  const TestFolder folder;
  const Dem dem = Dem::open(write_geotiff(drawn({"111", "1.1", "111"}), folder / "dem.tif"));
  EXPECT_FALSE(dem.sample({1001.5, 1998.5}));
  EXPECT_FALSE(dem.sample({1000.6, 1999.4}));
  EXPECT_TRUE(dem.sample({1000.5, 1999.5}));  // a centre, where the others weigh nothing
}

// A plane is reproduced exactly by bilinear sampling, whichever way the grid lies.
class DemTransforms : public testing::TestWithParam<std::array<double, 6>> {};

TEST_P(DemTransforms, ReproducesAPlane) {
  const auto plane = [](MapPoint p) { return 10 + 0.03 * (p.x - 5000) - 0.02 * (p.y - 7000); };
  const TestFolder folder;
  const Dem dem =
      Dem::open(write_geotiff(computed(300, 40, GetParam(), plane), folder / "dem.tif"));
  for (const auto& [column, row] : {std::pair{3.2, 5.9}, {150.0, 20.0}, {290.5, 38.1}}) {
    const MapPoint p = dem.to_map(column, row);
    ASSERT_TRUE(dem.sample(p));
    EXPECT_NEAR(dem.sample(p).value(), plane(p), 1e-4);
  }
}

INSTANTIATE_TEST_SUITE_P(NorthUpSouthUpRotatedAndOblong, DemTransforms,
                         testing::Values(std::array<double, 6>{5000, 1, 0, 7000, 0, -1},
                                         std::array<double, 6>{5000, 1, 0, 7000, 0, 1},
                                         std::array<double, 6>{5000, std::cos(pi / 6),
                                                               std::sin(pi / 6), 7000,
                                                               std::sin(pi / 6), -std::cos(pi / 6)},
                                         std::array<double, 6>{5000, 2, 0, 7000, 0, -0.5}));

TEST(Dem, FeetBecomeMetres) {
  const TestFolder folder;
  auto dem = drawn({"11", "11"}, 100);
  const auto file = write_geotiff(dem, folder / "plain.tif");
  EXPECT_NEAR(Dem::open(file, {.vertical_unit = "ft", .epsg = 0, .limits = {}})
                  .sample({1001, 1999})
                  .value(),
              30.48, 1e-5);
  dem.vertical_unit = "US survey foot";
  const Dem from_band = Dem::open(write_geotiff(dem, folder / "band.tif"));
  EXPECT_EQ(from_band.info().vertical_unit, "us-ft");
  EXPECT_NEAR(from_band.sample({1001, 1999}).value(), 100 * 1200.0 / 3937, 1e-5);
}

TEST(Dem, AMapInFeetNeedsItsVerticalUnitStated) {
  const TestFolder folder;
  auto drawing = drawn({"11", "11"});
  drawing.epsg = 2263;  // New York Long Island, US survey feet
  const auto file = write_geotiff(drawing, folder / "feet.tif");
  try {
    Dem::open(file);
    FAIL() << "a DEM without a vertical unit was taken";
  } catch (const DemError& error) {
    EXPECT_NE(std::string(error.what()).find("vertical_unit"), std::string::npos);
  }
  const Dem dem = Dem::open(file, {.vertical_unit = "m", .epsg = 0, .limits = {}});
  EXPECT_NEAR(dem.info().metres_per_unit, 1200.0 / 3937, 1e-9);
  EXPECT_NEAR(dem.info().cell_m(), 1200.0 / 3937, 1e-9);
}

TEST(Dem, ArcAsciiTakesItsCrsFromTheCaller) {
  const TestFolder folder;
  std::ofstream(folder / "dem.asc") << "ncols 2\nnrows 2\nxllcorner 1000\nyllcorner 2000\n"
                                       "cellsize 1\nNODATA_value 0\n3 4\n5 0\n";
  EXPECT_THROW(Dem::open(folder / "dem.asc"), DemError);
  const Dem dem = Dem::open(folder / "dem.asc", {.vertical_unit = "", .epsg = 2950, .limits = {}});
  EXPECT_DOUBLE_EQ(dem.sample({1000.5, 2001.5}).value(), 3);
  EXPECT_FALSE(dem.sample({1001.0, 2001.0}));
}

TEST(Dem, ReadsWindowsLargerThanATileAndAveragesThem) {
  const TestFolder folder;
  const auto east = [](MapPoint p) { return p.x; };
  const Dem dem =
      Dem::open(write_geotiff(computed(700, 300, {0, 1, 0, 300, 0, -1}, east), folder / "dem.tif"));
  const std::vector<float> halves = dem.read(0, 0, 700, 300, 350, 150);
  ASSERT_EQ(halves.size(), 350U * 150U);
  EXPECT_NEAR(halves[0], 1, 1e-3);
  EXPECT_NEAR(halves[349], 699, 1e-3);
  EXPECT_NEAR(dem.sample({612.25, 17.75}).value(), 612.25, 1e-3);
  EXPECT_THROW(dem.read(600, 0, 200, 10, 200, 10), DemError);
}

}  // namespace
}  // namespace leda::profiles
