#include "profiles/ground_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "profiles/lay_out_sections.hpp"
#include "profiles/register_dem.hpp"
#include "profiles/trace_profile.hpp"
#include "tests/profiles/drawn_dem.hpp"

namespace leda::profiles {
namespace {

using test::computed;
using test::TestFolder;
using test::write_geotiff;

// A bank across the middle of 200 x 200 cells of 1 map unit whose lower left corner is given.
std::filesystem::path bank_at(double x, double y, int epsg, const std::filesystem::path& file) {
  auto dem = computed(200, 200, {x, 1, 0, y + 200, 0, -1},
                      [y](MapPoint p) { return 20 - std::clamp((p.y - y - 80) / 2, 0.0, 15.0); });
  dem.epsg = epsg;
  return write_geotiff(dem, file);
}

TEST(GroundScale, OfMercatorIsTheCosineOfTheLatitude) {
  // On the sphere of the map's own formula; on the ellipsoid it differs by up to 0.7 %.
  const GroundScale scale(3857);
  const double y = 5780349.22;  // 46 degrees north
  const auto at = scale.at({-8125000, y});
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->most, std::cos(46 * std::numbers::pi / 180), 0.003);
  EXPECT_NEAR(at->least, at->most, 0.005);
  EXPECT_GT(at->departure(), 0.3);
  const std::string told = scale.complaint_at({-8125000, y}, most_departure);
  EXPECT_NE(told.find("EPSG:32618 (UTM zone 18)"), std::string::npos) << told;
  EXPECT_NE(told.find("is 0.69"), std::string::npos) << told;
}

TEST(GroundScale, OfATransverseMercatorIsItsFactorAtTheMeridian) {
  const auto mtm = GroundScale(2950).at({304800, 5100000});
  ASSERT_TRUE(mtm);
  EXPECT_NEAR(mtm->least, 1 / 0.9999, 1e-6);
  EXPECT_NEAR(mtm->most, 1 / 0.9999, 1e-6);
  const auto utm = GroundScale(32618).at({500000, 5100000});
  ASSERT_TRUE(utm);
  EXPECT_NEAR(utm->most, 1 / 0.9996, 1e-6);
  EXPECT_EQ(GroundScale(32618).complaint_at({500000, 5100000}, told_departure), "");
}

TEST(GroundScale, OfAnEqualAreaMapDiffersByDirection) {
  // EASE-Grid 2.0 at 46 degrees north: true at 30, stretched across and squeezed along.
  const auto at = GroundScale(6933).at({-7100000, 5250000});
  ASSERT_TRUE(at);
  EXPECT_LT(at->least, 0.9);
  EXPECT_GT(at->most, 1.1);
  EXPECT_NEAR(at->least * at->most, 1, 1e-4);
}

TEST(GroundScale, WherePROJKnowsNothingNothingIsSaid) {
  EXPECT_FALSE(GroundScale(2950).at({std::nan(""), 0}));
  EXPECT_EQ(GroundScale(999999).complaint_at({0, 0}, 0), "");
}

TEST(RegisterDem, AStretchedMapIsRefused) {
  const TestFolder folder;
  const auto file = bank_at(-8125000, 5780000, 3857, folder / "in.tif");
  try {
    register_dem(file, folder / "out.tif");
    FAIL() << "registered";
  } catch (const DemError& error) {
    EXPECT_NE(std::string(error.what()).find("EPSG:32618"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "out.tif"));
}

TEST(RegisterDem, ACellOnTheGroundIsTold) {
  const TestFolder folder;
  const auto good = register_dem(bank_at(500000, 5100000, 32618, folder / "a.tif"), folder / "b");
  ASSERT_TRUE(good.cell_ground_m);
  EXPECT_NEAR((*good.cell_ground_m)[0], 1 / 0.9996, 1e-6);
  EXPECT_TRUE(good.warnings.empty());
  // 6.5 degrees from the meridian of its zone, UTM is off by 0.27 %.
  const auto far = register_dem(bank_at(1000000, 5100000, 32618, folder / "c.tif"), folder / "d");
  ASSERT_EQ(far.warnings.size(), 1U);
  EXPECT_NE(far.warnings[0].find("EPSG:32619"), std::string::npos) << far.warnings[0];
}

TEST(LayOutSections, OnAStretchedMapIsAFault) {
  const TestFolder folder;
  const Dem dem = Dem::open(bank_at(-8125000, 5780000, 3857, folder / "in.tif"));
  SectionLayout layout;
  for (const double x : {-8124950.0, -8124900.0}) {
    layout.lines.push_back({"at " + std::to_string(x), {{x, 5780010}, {x, 5780190}}});
  }
  const auto laid = lay_out_sections(layout, dem);
  ASSERT_EQ(laid.faults.size(), 1U) << "told once";
  EXPECT_EQ(laid.faults[0].pointer, "/lines/0/line");
}

TEST(LayOutSections, ALineThatIsNoPlaneIsRefused) {
  const TestFolder folder;
  const Dem dem = Dem::open(bank_at(500000, 5100000, 32618, folder / "in.tif"));
  const auto laid = [&](const MapLine& line) {
    SectionLayout layout;
    layout.lines.push_back({"A", line});
    return lay_out_sections(layout, dem);
  };
  const auto turned =
      laid({{500100, 5100010}, {500100, 5100100}, {500190, 5100110}, {500150, 5100190}});
  ASSERT_EQ(turned.faults.size(), 1U);
  EXPECT_NE(turned.faults[0].message.find("turns 68 degrees off its way"), std::string::npos)
      << turned.faults[0].message;
  const auto ring =
      laid({{500050, 5100010}, {500050, 5100190}, {500150, 5100100}, {500050, 5100010}});
  ASSERT_FALSE(ring.faults.empty());
  EXPECT_NE(ring.faults[0].message.find("is a ring"), std::string::npos);
  const auto bent = laid({{500100, 5100010}, {500110, 5100100}, {500100, 5100190}});
  ASSERT_TRUE(bent.faults.empty());
  const auto cut = trace_profile(bent.sections.at(0), dem);
  const auto& warnings = std::get<Profile>(cut).warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("turns 6 degrees off its way"), std::string::npos) << warnings[0];
}

TEST(TraceProfile, ASmallDepartureIsAWarning) {
  const TestFolder folder;
  const Dem dem = Dem::open(bank_at(1000000, 5100000, 32618, folder / "in.tif"));
  SectionLayout layout;
  layout.lines.push_back({"A", {{1000100, 5100010}, {1000100, 5100190}}});
  const auto laid = lay_out_sections(layout, dem);
  ASSERT_TRUE(laid.faults.empty());
  const auto cut = trace_profile(laid.sections.at(0), dem);
  const auto& warnings = std::get<Profile>(cut).warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("EPSG:32618: 1 m of the map"), std::string::npos) << warnings[0];
}

}  // namespace
}  // namespace leda::profiles
