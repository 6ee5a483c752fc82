// Rasters that must be refused, each with a message that says what to do.

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <fstream>

#include "profiles/register_dem.hpp"
#include "tests/profiles/drawn_dem.hpp"
#include "tests/profiles/trap_rasters.hpp"

namespace leda::profiles {
namespace {

namespace fs = std::filesystem;
using test::drawn;
using test::TestFolder;
using test::write_geotiff;

std::string refusal(const fs::path& file, const DemOptions& options = {}) {
  const TestFolder folder;
  try {
    register_dem(file, folder / "out.tif", options);
  } catch (const DemError& error) {
    EXPECT_FALSE(fs::exists(folder / "out.tif"));
    EXPECT_TRUE(fs::is_empty(folder.path())) << "something was left behind";
    return error.what();
  }
  return "(taken)";
}

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST(HostileRaster, AVrtThatCallsItselfTiffIsNotOpened) {
  const TestFolder folder;
  const fs::path inside = write_geotiff(drawn({"11", "11"}), folder / "inside.tif");
  std::ofstream(folder / "dem.tif")
      << "<VRTDataset rasterXSize=\"2\" rasterYSize=\"2\"><VRTRasterBand dataType=\"Float32\" "
         "band=\"1\"><SimpleSource><SourceFilename>"
      << inside.string() << "</SourceFilename></SimpleSource></VRTRasterBand></VRTDataset>";
  EXPECT_SAYS(refusal(folder / "dem.tif"), "not a GeoTIFF, COG or Arc ASCII grid");
}

TEST(HostileRaster, NamesOfGdalsOwnFileSystemsAreRefused) {
  EXPECT_SAYS(refusal("/vsicurl/http://127.0.0.1:9/dem.tif"), "file on this machine");
  EXPECT_SAYS(refusal("/vsimem/dem.tif"), "file on this machine");
  EXPECT_SAYS(refusal("GTIFF_DIR:1:/nowhere/dem.tif"), "no file");
}

TEST(HostileRaster, NoDriverForAnythingElseExists) {
  initialize_gdal();
  for (const char* name : {"VRT", "WMS", "HTTP", "PDF", "netCDF", "DERIVED", "STACIT"}) {
    EXPECT_EQ(GetGDALDriverManager()->GetDriverByName(name), nullptr) << name;
  }
}

TEST(HostileRaster, ASmallFileThatDeclaresAHugeGrid) {
  const TestFolder folder;
  initialize_gdal();
  char sparse[] = "SPARSE_OK=TRUE", tiled[] = "TILED=YES", width[] = "BLOCKXSIZE=4096",
       height[] = "BLOCKYSIZE=4096", big[] = "BIGTIFF=YES";
  char* how[] = {sparse, tiled, width, height, big, nullptr};
  GDALDataset* huge = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
      (folder / "huge.tif").c_str(), 200000, 200000, 1, GDT_Float32, how);
  ASSERT_NE(huge, nullptr);
  GDALClose(GDALDataset::ToHandle(huge));
  EXPECT_LT(fs::file_size(folder / "huge.tif"), 1U << 20);
  const std::string text = refusal(folder / "huge.tif");
  EXPECT_SAYS(text, "200000 x 200000");
  EXPECT_SAYS(text, "-projwin");
}

TEST(HostileRaster, BlocksTooLargeToReadInWindows) {
  const TestFolder folder;
  initialize_gdal();
  char sparse[] = "SPARSE_OK=TRUE", tiled[] = "TILED=YES", width[] = "BLOCKXSIZE=16384",
       height[] = "BLOCKYSIZE=16384";
  char* how[] = {sparse, tiled, width, height, nullptr};
  GDALDataset* blocks = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
      (folder / "blocks.tif").c_str(), 20000, 20000, 1, GDT_Float32, how);
  ASSERT_NE(blocks, nullptr);
  GDALClose(GDALDataset::ToHandle(blocks));
  const std::string text = refusal(folder / "blocks.tif");
  EXPECT_SAYS(text, "16384 x 16384");
  EXPECT_SAYS(text, "TILED=YES");
}

TEST(HostileRaster, DegreesNoCrsSeveralBandsAndOddUnits) {
  const TestFolder folder;
  auto dem = drawn({"11", "11"});
  dem.epsg = 4326;
  EXPECT_SAYS(refusal(write_geotiff(dem, folder / "degrees.tif")), "gdalwarp -t_srs");
  dem.epsg = 0;
  EXPECT_SAYS(refusal(write_geotiff(dem, folder / "none.tif")), "-a_srs");
  dem.epsg = 2950;
  dem.bands = 3;
  EXPECT_SAYS(refusal(write_geotiff(dem, folder / "bands.tif")), "gdal_translate -b 1");
  dem.bands = 1;
  dem.vertical_unit = "fathom";
  EXPECT_SAYS(refusal(write_geotiff(dem, folder / "fathoms.tif")), "fathom");
  dem.vertical_unit = "";
  const auto sound = write_geotiff(dem, folder / "sound.tif");
  EXPECT_SAYS(refusal(sound, {.vertical_unit = "furlong", .epsg = 0, .limits = {}}), "furlong");
  EXPECT_SAYS(refusal(sound, {.vertical_unit = "", .epsg = 26915, .limits = {}}), "EPSG:2950");
}

TEST(HostileRaster, NoDataAtAllAndElevationsThatAreNoGround) {
  const TestFolder folder;
  EXPECT_SAYS(refusal(write_geotiff(drawn({"..", ".."}), folder / "empty.tif")), "holds data");
  auto dem = drawn({"11", "1."});
  dem.cells[3] = -32768;  // missing, but not declared
  EXPECT_SAYS(refusal(write_geotiff(dem, folder / "undeclared.tif")), "-a_nodata");
}

TEST(HostileRaster, TextAndTruncatedFiles) {
  const TestFolder folder;
  std::ofstream(folder / "text.tif") << "this is no raster";
  EXPECT_SAYS(refusal(folder / "text.tif"), "not a GeoTIFF");
  const auto whole = write_geotiff(drawn(std::vector<std::string>(200, std::string(200, '3'))),
                                   folder / "whole.tif");
  fs::resize_file(whole, fs::file_size(whole) / 2);
  EXPECT_NE(refusal(whole), "(taken)");
}

class TrapRasters : public testing::Test {
 protected:
  void SetUp() override { test::write_trap_rasters(traps.path()); }
  const TestFolder traps;
};

TEST_F(TrapRasters, AreRefusedAsTheyAre) {
  EXPECT_SAYS(refusal(traps / "engineering_90m.tif"), "not a projected one");
  for (const char* name : {"gully.asc", "sieve.asc", "rotated.tif", "south_up.tif", "degrees.asc"})
    EXPECT_SAYS(refusal(traps / name), "no coordinate reference system");
  EXPECT_SAYS(refusal(traps / "four_bands.tif"), "4 bands");
  EXPECT_SAYS(refusal(traps / "degrees.asc", {.vertical_unit = "", .epsg = 26913, .limits = {}}),
              "degrees");
}

TEST_F(TrapRasters, WithACrsStatedByTheCallerAreRead) {
  const TestFolder out;
  const DemOptions utm{.vertical_unit = "", .epsg = 26913, .limits = {}};
  EXPECT_NEAR(register_dem(traps / "gully.asc", out / "a.tif", utm).share_with_data, 0.28, 1e-6);
  EXPECT_NEAR(register_dem(traps / "sieve.asc", out / "b.tif", utm).share_with_data, 0.74, 1e-6);
  EXPECT_TRUE(register_dem(traps / "rotated.tif", out / "c.tif", utm).info.rotated);
  const auto south_up = register_dem(traps / "south_up.tif", out / "d.tif", utm);
  EXPECT_EQ(south_up.info.box, (MapBox{0, 0, 300, 200}));
  EXPECT_NEAR(south_up.share_with_data, 5.0 / 6, 1e-6);
}

}  // namespace
}  // namespace leda::profiles
