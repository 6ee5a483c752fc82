#include "profiles/trace_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "profiles/map_geometry.hpp"
#include "tests/profiles/drawn_dem.hpp"

namespace leda::profiles {
namespace {

using test::computed;
using test::drawn;
using test::TestFolder;
using test::write_geotiff;

// From north to south: plateau at 20 m, a face of 40 m from y = 300 to 260, flat at 0 m.
double bank(MapPoint p) { return std::clamp((p.y - 260) * 0.5, 0.0, 20.0); }

class Trace : public testing::Test {
 protected:
  Dem open(const std::function<double(MapPoint)>& ground, int epsg = 2950) {
    auto drawing = computed(200, 400, {0, 1, 0, 400, 0, -1}, ground);
    drawing.epsg = epsg;
    return Dem::open(write_geotiff(drawing, folder_ / "dem.tif"),
                     {.vertical_unit = "m", .epsg = 0, .limits = {}});
  }
  TestFolder folder_;
};

LaidSection section_at(double x) {
  LaidSection section;
  section.name = "S001";
  section.line = 0;
  section.trace = {{x, 390}, {x, 190}};
  return section;
}

TEST_F(Trace, FindsTheBreaksOfAPlainBank) {
  const auto cut = trace_profile(section_at(100), open(bank));
  ASSERT_TRUE(std::holds_alternative<Profile>(cut));
  const auto& profile = std::get<Profile>(cut);
  EXPECT_NEAR(profile.bank.crest.x, 90, 1.5);
  EXPECT_NEAR(profile.bank.crest.z, 20, 0.2);
  EXPECT_NEAR(profile.bank.toe.x, 130, 1.5);
  EXPECT_NEAR(profile.bank.toe.z, 0, 0.2);
  EXPECT_DOUBLE_EQ(profile.ground.front().x, 0);
  EXPECT_NEAR(profile.ground.back().x, 200, 1e-9);
  EXPECT_LE(profile.ground.size(), 12U);
  EXPECT_TRUE(profile.warnings.empty());
}

TEST_F(Trace, ADrawnBank) {
  const Dem dem = Dem::open(write_geotiff(drawn({"999999876543211111111111",  //
                                                 "999999876543211111111111",  //
                                                 "999999876543211111111111"},
                                                1, 2),
                                          folder_ / "drawn.tif"));
  LaidSection section;
  section.name = "drawn";
  section.trace = {{1001, 1997}, {1047, 1997}};
  const auto cut = trace_profile(section, dem);
  ASSERT_TRUE(std::holds_alternative<Profile>(cut));
  EXPECT_NEAR(std::get<Profile>(cut).bank.crest.x, 10, 0.5);  // the centre of the last 9
  EXPECT_NEAR(std::get<Profile>(cut).bank.toe.x, 26, 0.5);    // the centre of the first 1
}

TEST_F(Trace, SimplifiesWithinTheTolerance) {
  const auto rough = [](MapPoint p) { return bank(p) + std::sin(p.y / 3) + 0.3 * std::sin(p.y); };
  const Dem dem = open(rough);
  const Polyline samples = sample_ground(section_at(100).trace, dem);
  const Polyline simple = simplify(samples, 0.05);
  EXPECT_LT(simple.size(), samples.size());
  EXPECT_GE(samples.size(), 400U);
  for (const Point& p : samples) EXPECT_NEAR(elevation_at(simple, p.x), p.z, 0.05 + 1e-12);
}

TEST_F(Trace, MissingDataBeyondTheToeShortensTheSection) {
  const auto ground = [](MapPoint p) { return p.y < 215 ? std::nan("") : bank(p); };
  const auto cut = trace_profile(section_at(100), open(ground));
  ASSERT_TRUE(std::holds_alternative<Profile>(cut));
  const auto& profile = std::get<Profile>(cut);
  EXPECT_NEAR(profile.ground.back().x, 174, 1.5);
  EXPECT_NEAR(length_of(profile.trace), profile.ground.back().x, 1e-9);
  ASSERT_EQ(profile.warnings.size(), 1U);
  EXPECT_NE(profile.warnings[0].find("shortened"), std::string::npos);
}

TEST_F(Trace, MissingDataAtTheStartMovesTheStart) {
  const auto ground = [](MapPoint p) { return p.y > 350 ? std::nan("") : bank(p); };
  const auto cut = trace_profile(section_at(100), open(ground));
  ASSERT_TRUE(std::holds_alternative<Profile>(cut));
  const auto& profile = std::get<Profile>(cut);
  EXPECT_DOUBLE_EQ(profile.ground.front().x, 0);
  EXPECT_NEAR(profile.trace.front().y, 349, 1.5);
  EXPECT_NEAR(profile.trace.front().y - profile.bank.crest.x, 300, 1.5);
}

TEST_F(Trace, AHoleInTheFaceLeavesTheSectionOut) {
  const auto ground = [](MapPoint p) { return p.y > 255 && p.y < 275 ? std::nan("") : bank(p); };
  const auto cut = trace_profile(section_at(100), open(ground));
  ASSERT_TRUE(std::holds_alternative<LeftOut>(cut));
  EXPECT_NE(std::get<LeftOut>(cut).reason.find("no data at the crest or the toe"),
            std::string::npos);
}

TEST_F(Trace, NoBankAndNoDataAreReasons) {
  const auto flat = trace_profile(section_at(100), open([](MapPoint) { return 5.0; }));
  ASSERT_TRUE(std::holds_alternative<LeftOut>(flat));
  EXPECT_NE(std::get<LeftOut>(flat).reason.find("no bank of at least 2 m"), std::string::npos);
  const auto ground = [](MapPoint p) { return p.x > 50 ? std::nan("") : 5.0; };
  const auto empty = trace_profile(section_at(100), open(ground));
  ASSERT_TRUE(std::holds_alternative<LeftOut>(empty));
  EXPECT_NE(std::get<LeftOut>(empty).reason.find("no data along"), std::string::npos);
}

TEST_F(Trace, CrestAndToeByHandWin) {
  LaidSection section = section_at(100);
  section.crest = MapPoint{101, 320};
  section.toe = MapPoint{99, 250};
  const auto cut = trace_profile(section, open(bank));
  ASSERT_TRUE(std::holds_alternative<Profile>(cut));
  EXPECT_NEAR(std::get<Profile>(cut).bank.crest.x, 70, 1e-9);
  EXPECT_NEAR(std::get<Profile>(cut).bank.toe.x, 140, 1e-9);
}

TEST_F(Trace, ABankThatReachesTheEndIsFlagged) {
  LaidSection section = section_at(100);
  section.trace = {{100, 295}, {100, 190}};
  const auto cut = trace_profile(section, open(bank));
  ASSERT_TRUE(std::holds_alternative<Profile>(cut));
  ASSERT_EQ(std::get<Profile>(cut).warnings.size(), 1U);
  EXPECT_NE(std::get<Profile>(cut).warnings[0].find("reaches the end"), std::string::npos);
}

TEST_F(Trace, CellsTooCoarseForTheBankAreTold) {
  // A face of 3 m over 1.5 m: on cells of 1 m it may as well be vertical.
  const auto low = [](MapPoint p) { return std::clamp((p.y - 260) * 2, 0.0, 3.0); };
  const auto cut = trace_profile(section_at(100), open(low));
  const auto& warnings = std::get<Profile>(cut).warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("the DEM's cells of 1 m are coarse for a bank"), std::string::npos)
      << warnings[0];
  // The same face of 20 m: a cell more or less hardly matters.
  const auto high = [](MapPoint p) { return std::clamp((p.y - 260) * 14, 0.0, 20.0); };
  EXPECT_TRUE(std::get<Profile>(trace_profile(section_at(100), open(high))).warnings.empty());
}

TEST_F(Trace, AMapInFeetGivesAProfileInMetres) {
  const auto cut = trace_profile(section_at(100), open(bank, 2263));
  ASSERT_TRUE(std::holds_alternative<Profile>(cut));
  EXPECT_NEAR(std::get<Profile>(cut).ground.back().x, 200 * 1200.0 / 3937, 1e-6);
  EXPECT_NEAR(std::get<Profile>(cut).bank.crest.x, 90 * 1200.0 / 3937, 0.5);
  EXPECT_NEAR(length_of(std::get<Profile>(cut).trace), 200, 1e-9);
}

}  // namespace
}  // namespace leda::profiles
