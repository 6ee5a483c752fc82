#include "profiles/hillshade.hpp"

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>

#include "profiles/gdal_handle.hpp"
#include "tests/profiles/drawn_dem.hpp"

namespace leda::profiles {
namespace {

using test::computed;
using test::TestFolder;
using test::write_geotiff;

// A ridge from west to east at y = 50: its north side faces the light (315 degrees), its south
// side lies in shade. The south-east quarter has no data.
double ridge(MapPoint p) {
  return p.x > 50 && p.y < 50 ? std::nan("") : 30 - 0.5 * std::abs(p.y - 50);
}

std::vector<unsigned char> band_of(GDALDataset& png, int band) {
  const int width = png.GetRasterXSize(), height = png.GetRasterYSize();
  std::vector<unsigned char> cells(static_cast<std::size_t>(width * height));
  EXPECT_EQ(png.GetRasterBand(band)->RasterIO(GF_Read, 0, 0, width, height, cells.data(), width,
                                              height, GDT_Byte, 0, 0, nullptr),
            CE_None);
  return cells;
}

DatasetHandle open_png(const std::filesystem::path& file) {
  return DatasetHandle(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER));
}

class Hillshade : public testing::TestWithParam<std::array<double, 6>> {};

TEST_P(Hillshade, LightFromTheNorthWestWhicheverWayTheRowsRun) {
  const TestFolder folder;
  const Dem dem =
      Dem::open(write_geotiff(computed(100, 100, GetParam(), ridge), folder / "dem.tif"));
  const Picture picture = write_hillshade(dem, folder / "shade.png");
  EXPECT_EQ(picture.width, 100);
  EXPECT_EQ(picture.box, (MapBox{0, 0, 100, 100}));
  const DatasetHandle png = open_png(folder / "shade.png");
  ASSERT_TRUE(png);
  const auto grey = band_of(*png, 1), alpha = band_of(*png, 2);
  EXPECT_GT(grey[20 * 100 + 20], grey[80 * 100 + 20] + 50);  // north side against south side
  EXPECT_EQ(alpha[20 * 100 + 80], 255);
  EXPECT_EQ(alpha[80 * 100 + 80], 0);
}

INSTANTIATE_TEST_SUITE_P(NorthUpAndSouthUp, Hillshade,
                         testing::Values(std::array<double, 6>{0, 1, 0, 100, 0, -1},
                                         std::array<double, 6>{0, 1, 0, 0, 0, 1}));

TEST(Hillshade, IsCutAndShrunk) {
  const TestFolder folder;
  const Dem dem = Dem::open(write_geotiff(
      computed(100, 100, {0, 1, 0, 100, 0, -1}, [](MapPoint p) { return p.x; }), folder / "d.tif"));
  const Picture picture = write_hillshade(dem, folder / "shade.png",
                                          {.window = MapBox{10, 20, 90, 60}, .most_pixels = 40});
  EXPECT_EQ(picture.width, 40);
  EXPECT_EQ(picture.height, 20);
  EXPECT_EQ(picture.box, (MapBox{10, 20, 90, 60}));
  EXPECT_THROW(write_hillshade(dem, folder / "s.png", {.window = MapBox{900, 900, 990, 990}}),
               DemError);
}

// Two first viewers of one DEM.
TEST(Hillshade, SeveralMayWriteTheSameFileAtOnce) {
  const TestFolder folder;
  const auto file =
      write_geotiff(computed(400, 400, {0, 1, 0, 400, 0, -1}, ridge), folder / "dem.tif");
  std::vector<std::thread> viewers;
  std::atomic<int> failed{0};
  for (int i = 0; i < 8; ++i) {
    viewers.emplace_back([&] {
      try {
        write_hillshade(Dem::open(file), folder / "shade.png");
      } catch (const std::exception&) {
        ++failed;
      }
    });
  }
  for (std::thread& viewer : viewers) viewer.join();
  EXPECT_EQ(failed, 0);
  const DatasetHandle png = open_png(folder / "shade.png");
  ASSERT_TRUE(png);
  EXPECT_EQ(png->GetRasterXSize(), 400);
  for (const auto& entry : std::filesystem::directory_iterator(folder / "")) {
    EXPECT_EQ(entry.path().string().find(".tmp"), std::string::npos) << entry.path();
  }
}

}  // namespace
}  // namespace leda::profiles
