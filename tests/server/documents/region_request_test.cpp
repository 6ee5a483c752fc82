#include "server/documents/region_request.hpp"

#include <gtest/gtest.h>

#include "tests/server/documents/read_data.hpp"
#include "tests/server/documents/region_text.hpp"

namespace leda::server {
namespace {

RegionRequest parsed(const nlohmann::json& document,
                     DemNaming naming = DemNaming::registered_only) {
  auto result = parse_region_request(document.dump(), naming);
  EXPECT_TRUE(result) << test::text(result.faults);
  return result ? *result.value : RegionRequest{};
}

TEST(RegionRequest, EverythingArrives) {
  const RegionRequest r = parsed(test::region());
  EXPECT_EQ(r.name, "sainte-monique");
  EXPECT_EQ(r.dem, "sainte-monique");
  ASSERT_EQ(r.layout.lines.size(), 2U);
  EXPECT_EQ(r.layout.lines[0].name, "AA'");
  EXPECT_EQ(r.layout.lines[0].crest, (MapPoint{180, 6}));
  EXPECT_EQ(r.layout.lines[1].line.size(), 3U);
  EXPECT_FALSE(r.layout.lines[1].toe);
  ASSERT_EQ(r.layout.along.size(), 1U);
  EXPECT_EQ(r.layout.along[0].spacing_m, 50);
  EXPECT_EQ(r.layout.along[0].upslope_m, 250);
  ASSERT_EQ(r.soil.size(), 2U);
  EXPECT_EQ(r.soil[0].name, "plain");
  EXPECT_EQ(r.soil[0].water_table->depth_m, 1.0);
  EXPECT_FALSE(r.soil[0].base_m);
  EXPECT_TRUE(r.soil[0].where.empty());
  EXPECT_EQ(r.soil[0].materials.at("clay").peak_strength.constant_Pa, 40e3);
  EXPECT_EQ(r.soil[1].base_m, -2.0);
  EXPECT_EQ(r.soil[1].where.at(0).outer.size(), 4U);
  EXPECT_EQ(r.settings.time_step_factor, 0.4);
  EXPECT_EQ(std::get<UndrainedTrigger>(r.settings.trigger).then_toe_cut_m, 3.0);
  EXPECT_FALSE(r.skip_stable);
}

TEST(RegionRequest, SmallestHasTheDefaults) {
  const RegionRequest r = parsed(test::small_region());
  EXPECT_TRUE(r.layout.lines.empty());
  EXPECT_EQ(r.layout.along.size(), 1U);
  EXPECT_EQ(r.soil.size(), 1U);
  EXPECT_EQ(r.soil[0].base_below_toe_m, 5);
  EXPECT_TRUE(r.skip_stable);
  EXPECT_EQ(r.settings.stop.max_time_s, 120);
}

TEST(RegionRequest, StrengthOfASoilModelMayVaryWithinTheGround) {
  auto document = test::small_region();
  auto& clay = document["inputs"]["soil"]["materials"]["clay"];
  clay["field"] = {{"cov", 0.2}, {"horizontal_m", 40}, {"vertical_m", 2.5}};
  const auto field = parsed(document).soil[0].materials.at("clay").field;
  ASSERT_TRUE(field.has_value());
  EXPECT_EQ(field->cov, 0.2);
  EXPECT_EQ(field->horizontal_m, 40);
  EXPECT_EQ(field->vertical_m, 2.5);
  clay["field"]["cov"] = 2;
  const auto faults = parse_region_request(document.dump(), DemNaming::registered_only).faults;
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].pointer, "/inputs/soil/materials/clay/field/cov");
}

TEST(RegionRequest, TenThousandSectionsAreAJobAndMoreThanTheLimitAreNot) {
  auto document = test::small_region();
  auto& along = document["inputs"]["sections"];
  along["along"] = {{0, 0}, {0, 500'000}};
  EXPECT_EQ(parsed(document).layout.along[0].along[1].y, 500'000);
  along["spacing_m"] = 1;
  const auto refused = parse_region_request(document.dump(), DemNaming::registered_only);
  EXPECT_EQ(test::pointers(refused.faults), (std::multiset<std::string>{"/inputs/sections"}));
  RegionLimits limits;
  limits.most_sections = 600'000;
  EXPECT_TRUE(parse_region_request(document.dump(), DemNaming::registered_only, limits));
}

TEST(RegionRequest, ADemIsAPathOnlyWhereThatIsAllowed) {
  auto document = test::small_region();
  for (const char* path : {"/data/dem.tif", "../dem.tif", "dem..tif", "C:dem", "vsimem", "VSIcurl",
                           "<VRTDataset>", "a\\b"}) {
    document["inputs"]["dem"] = path;
    const auto refused = parse_region_request(document.dump(), DemNaming::registered_only);
    EXPECT_EQ(test::pointers(refused.faults), (std::multiset<std::string>{"/inputs/dem"})) << path;
  }
  document["inputs"]["dem"] = "../data/dem.tif";
  EXPECT_EQ(parsed(document, DemNaming::path_allowed).dem, "../data/dem.tif");
  for (const char* path : {"/vsicurl/http://example.org/a.tif", "<VRTDataset>"}) {
    document["inputs"]["dem"] = path;
    EXPECT_FALSE(parse_region_request(document.dump(), DemNaming::path_allowed)) << path;
  }
}

}  // namespace
}  // namespace leda::server
