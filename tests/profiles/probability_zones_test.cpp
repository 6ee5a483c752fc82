#include "profiles/probability_zones.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "profiles/areas.hpp"
#include "profiles/dem.hpp"
#include "profiles/export_layers.hpp"
#include "profiles/gdal_handle.hpp"
#include "profiles/probability_raster.hpp"
#include "tests/server/temporary_folder.hpp"

namespace leda::profiles {
namespace {

const std::vector<double> exceedance{0.05, 0.5, 0.95};

/// A section across a river along x, from y = 300 on the plateau down to y = 0: crest 200 m and toe
/// 220 m along it.
SectionQuantiles section(double x, const std::vector<std::optional<double>>& retrogression,
                         double runout) {
  SectionQuantiles one;
  one.profile.section = "S" + std::to_string(static_cast<int>(x));
  one.profile.trace = {{x, 300}, {x, 0}};
  one.profile.ground = {{0, 20}, {200, 20}, {220, 8}, {300, 8}};
  one.profile.bank = {{200, 20}, {220, 8}};
  one.line = 0;
  one.order = x;
  one.members = 64;
  for (const auto& distance : retrogression) {
    one.retrogression.push_back({distance, Bound::measured});
    const bool stands = distance && *distance == 0;
    one.runout.push_back({stands ? 0 : runout, Bound::measured});
  }
  one.made_by = "hash";
  return one;
}

SectionQuantiles left_out(double x) {
  SectionQuantiles one = section(x, {}, 0);
  one.reason = "it could not be cut";
  return one;
}

GeometryHandle area_of(const std::vector<Zone>& zones, ZoneKind kind, double p) {
  std::vector<MapPolygon> area;
  for (const Zone& zone : zones) {
    if (zone.kind != kind || zone.probability.value().exceedance != p) continue;
    area.insert(area.end(), zone.area.begin(), zone.area.end());
  }
  return to_ogr(area);
}

double size_of(const OGRGeometry& area) {
  return OGR_G_Area(OGRGeometry::ToHandle(const_cast<OGRGeometry*>(&area)));
}

void expect_nested(const std::vector<Zone>& zones) {
  for (const ZoneKind kind : {ZoneKind::release, ZoneKind::runout}) {
    for (std::size_t i = 0; i + 1 < exceedance.size(); ++i) {
      const GeometryHandle outer = area_of(zones, kind, exceedance[i]);
      const GeometryHandle inner = area_of(zones, kind, exceedance[i + 1]);
      ASSERT_TRUE(outer->IsValid());
      const GeometryHandle both(inner->Intersection(outer.get()));
      EXPECT_NEAR(size_of(*both), size_of(*inner), 1e-6)
          << to_string(kind) << " " << exceedance[i + 1];
    }
  }
}

TEST(ProbabilityZones, ASectionsQuantilesAreTheEdgesOfItsZones) {
  const auto zones = probability_zones({section(0, {100, 60, 20}, 10)}, exceedance);
  ASSERT_EQ(zones.size(), 6U);
  EXPECT_EQ(zones[0].probability->exceedance, 0.05) << "the largest comes first";
  EXPECT_EQ(zones[0].probability->members, 64);
  // A strip of 20 m from the toe at y = 80 to crest and retrogression behind it.
  for (std::size_t i = 0; i < exceedance.size(); ++i) {
    const double retrogression[] = {100, 60, 20};
    const GeometryHandle area = area_of(zones, ZoneKind::release, exceedance[i]);
    EXPECT_NEAR(size_of(*area), 20 * (20 + retrogression[i]), 1e-6);
  }
}

TEST(ProbabilityZones, AreNestedAlsoWhereSectionsSeldomMoveOrAreMissing) {
  const auto zones = probability_zones(
      {section(0, {100, 60, 20}, 10), section(50, {150, 0, 0}, 30), section(100, {90, 80, 0}, 5),
       left_out(150), section(200, {40, 30, 20}, 9), section(230, {180, 90, 30}, 60)},
      exceedance);
  expect_nested(zones);
}

TEST(ProbabilityZones, ADistanceThatIsNotKnownGoesToTheEndOfTheSection) {
  const auto zones = probability_zones({section(0, {std::nullopt, 60, 20}, 10)}, exceedance);
  EXPECT_EQ(zones[0].largest_distance_m, 200);
  EXPECT_EQ(zones[0].distance_is, Bound::lower_bound);
  expect_nested(zones);
}

TEST(ProbabilityZones, WhereNoMemberMovesThereIsNone) {
  EXPECT_TRUE(probability_zones({section(0, {0, 0, 0}, 0)}, exceedance).empty());
}

class ProbabilityRasterOf : public testing::Test {
 protected:
  /// @return the value at a point, and nothing else of the file
  float at(double x, double y) {
    double transform[6];
    raster->GetGeoTransform(transform);
    const int column = static_cast<int>(std::floor((x - transform[0]) / transform[1]));
    const int row = static_cast<int>(std::floor((y - transform[3]) / transform[5]));
    float value = 0;
    EXPECT_EQ(raster->GetRasterBand(1)->RasterIO(GF_Read, column, row, 1, 1, &value, 1, 1,
                                                 GDT_Float32, 0, 0, nullptr),
              CE_None);
    return value;
  }

  void write(const std::vector<SectionQuantiles>& sections) {
    ProbabilityRaster wanted;
    wanted.epsg = 2950;
    wanted.cell = 1;
    wanted.zones = probability_zones(sections, exceedance);
    std::erase_if(wanted.zones, [](const Zone& zone) { return zone.kind != ZoneKind::release; });
    for (const Zone& zone : zones_spoken_of(sections)) {
      if (zone.kind != ZoneKind::release) continue;
      wanted.spoken_for.insert(wanted.spoken_for.end(), zone.area.begin(), zone.area.end());
    }
    wanted.description = "for a test";
    write_probability_raster(wanted, file);
    initialize_gdal();
    raster.reset(GDALDataset::Open(file.c_str()));
    ASSERT_TRUE(raster);
  }

  tests::TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "release_probability.tif";
  DatasetHandle raster;
};

TEST_F(ProbabilityRasterOf, HoldsTheLargestProbabilityWhoseZoneHoldsACell) {
  write({section(0, {100, 60, 20}, 10), section(50, {100, 60, 20}, 10)});
  ASSERT_EQ(raster->GetRasterCount(), 1);
  const double toe = 80, crest = 100;
  EXPECT_FLOAT_EQ(at(25.5, toe + 1.5), 0.95F);
  EXPECT_FLOAT_EQ(at(25.5, crest + 19.5), 0.95F);
  EXPECT_FLOAT_EQ(at(25.5, crest + 20.5), 0.5F);
  EXPECT_FLOAT_EQ(at(25.5, crest + 60.5), 0.05F);
  EXPECT_FLOAT_EQ(at(25.5, crest + 100.5), 0) << "computed, never reached";
  EXPECT_EQ(raster->GetRasterBand(1)->GetNoDataValue(), -9999);
  EXPECT_STREQ(raster->GetDriverName(), "GTiff");
  EXPECT_STREQ(raster->GetMetadataItem("LAYOUT", "IMAGE_STRUCTURE"), "COG");
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "release_probability.qml"));
}

TEST_F(ProbabilityRasterOf, WhereNoSectionSpeaksThereIsNoData) {
  write({section(0, {100, 60, 20}, 10), left_out(50), section(100, {100, 60, 20}, 10)});
  EXPECT_FLOAT_EQ(at(20.5, 100), 0.95F);
  EXPECT_FLOAT_EQ(at(50.5, 100), -9999) << "half-way to a section without members it ends";
}

TEST_F(ProbabilityRasterOf, ThatWouldBeTooLargeIsRefused) {
  ProbabilityRaster wanted;
  wanted.epsg = 2950;
  wanted.cell = 1e-3;
  wanted.spoken_for = {{{{0, 0}, {100, 0}, {100, 100}, {0, 0}}, {}}};
  EXPECT_THROW(write_probability_raster(wanted, file), ExportError);
  EXPECT_FALSE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace leda::profiles
