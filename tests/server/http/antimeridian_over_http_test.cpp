// Features on both sides of 180 degrees, as clients find them.

#include <cmath>
#include <set>

#include "server/layers/features.hpp"
#include "tests/db/samples.hpp"
#include "tests/server/http/http_fixture.hpp"

namespace leda::server {
namespace {

/// A job in zone 60 of UTM, which goes on beyond 180 degrees: at 17 degrees south these lie at an
/// easting of about 819 km.
class Antimeridian : public HttpServerTest {
 protected:
  static constexpr double northing = 8'118'000;

  static db::SectionRecord section(const std::string& name, int ordinal, double from, double to) {
    db::SectionRecord one = db::samples::section(name, ordinal);
    one.trace = {{from, northing}, {to, northing}};
    return one;
  }

  void SetUp() override {
    db::RasterRecord raster = db::samples::raster();
    raster.epsg = 32760;
    service.store.add_raster(raster);
    db::JobRecord job = db::samples::job("fiji");
    job.state = db::JobState::successful;
    job.raster = raster.id;
    service.store.add_job(job);
    service.store.set_sections(
        "fiji", {section("over", 0, 815e3, 825e3), section("west of it", 1, 780e3, 790e3),
                 section("east of it", 2, 850e3, 860e3)});
    Zone zone;
    zone.kind = ZoneKind::release;
    zone.sections = {"over"};
    zone.area = {{{{815e3, northing},
                   {825e3, northing},
                   {825e3, northing + 1e3},
                   {815e3, northing + 1e3},
                   {815e3, northing}},
                  {}}};
    service.store.set_zones("fiji", {zone});
    keep_section_boxes(service.store, job);
    keep_zone_boxes(service.store, job);
  }

  std::set<std::string> inside(const std::string& bbox) {
    const json items = ok("/collections/sections/items?job=fiji&bbox=" + bbox);
    std::set<std::string> names;
    for (const json& feature : items["features"]) names.insert(feature["properties"]["name"]);
    EXPECT_EQ(items["numberMatched"], names.size()) << bbox;
    return names;
  }
};

using Names = std::set<std::string>;

TEST_F(Antimeridian, AFeatureOverItComesInTwoParts) {
  const json line = ok("/collections/sections/items?job=fiji")["features"][0]["geometry"];
  ASSERT_EQ(line["type"], "MultiLineString");
  ASSERT_EQ(line["coordinates"].size(), 2U);
  EXPECT_EQ(line["coordinates"][0].back()[0], 180);
  EXPECT_EQ(line["coordinates"][1].front()[0], -180);
  const json zone = ok("/collections/release_zones/items?job=fiji")["features"][0]["geometry"];
  ASSERT_EQ(zone["type"], "MultiPolygon");
  ASSERT_EQ(zone["coordinates"].size(), 2U);
  for (const json& polygon : zone["coordinates"]) {
    double west = 180, east = -180;
    for (const json& point : polygon[0]) {
      west = std::min(west, point[0].get<double>());
      east = std::max(east, point[0].get<double>());
    }
    EXPECT_LT(east - west, 0.1) << polygon.dump();
  }
}

TEST_F(Antimeridian, ABoxFindsWhatLiesOnItsSide) {
  EXPECT_EQ(inside("170,-18,180,-16"), (Names{"over", "west of it"}));
  EXPECT_EQ(inside("-180,-18,-170,-16"), (Names{"over", "east of it"}));
  EXPECT_EQ(inside("175,-18,-175,-16"), (Names{"over", "west of it", "east of it"}));
  EXPECT_EQ(inside("0,-18,10,-16"), Names{});
  EXPECT_EQ(ok("/collections/release_zones/items?bbox=-180,-18,-179,-16")["numberMatched"], 1);
  EXPECT_EQ(ok("/collections/release_zones/items?bbox=0,-18,10,-16")["numberMatched"], 0);
}

TEST_F(Antimeridian, ABoxThatCountsOnBeyondItCrossesIt) {
  EXPECT_EQ(inside("175,-18,185,-16"), (Names{"over", "west of it", "east of it"}));
  EXPECT_EQ(inside("-185,-18,-175,-16"), (Names{"over", "west of it", "east of it"}));
  EXPECT_EQ(inside("180.1,-18,185,-16"), Names{"east of it"});
  EXPECT_EQ(inside("-185,-18,-180.1,-16"), Names{"west of it"});
  EXPECT_EQ(inside("-200,-18,200,-16"), (Names{"over", "west of it", "east of it"}))
      << "more than the world";
  EXPECT_EQ(inside("360,-18,370,-16"), Names{});
}

}  // namespace
}  // namespace leda::server
