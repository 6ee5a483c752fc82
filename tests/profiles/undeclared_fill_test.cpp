#include "profiles/undeclared_fill.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "profiles/lay_out_sections.hpp"
#include "profiles/register_dem.hpp"
#include "tests/profiles/drawn_dem.hpp"

namespace leda::profiles {
namespace {

using test::computed;
using test::TestFolder;
using test::write_geotiff;

// A rolling plain at about 50 m, 200 x 100 m; east of x = 1150 there is something else.
std::filesystem::path plain_and(const std::function<double(MapPoint)>& east,
                                const std::filesystem::path& file) {
  return write_geotiff(computed(200, 100, {1000, 1, 0, 2100, 0, -1},
                                [&](MapPoint p) {
                                  if (p.x > 1150) return east(p);
                                  return 50 + std::sin(p.x / 9) + std::sin(p.y / 7);
                                }),
                       file);
}

TEST(UndeclaredFill, APieceOfOneValueFarBelowTheGroundIsFound) {
  for (const double value : {0.0, -99.0, -1.0, 255.0, 999.0}) {
    const TestFolder folder;
    const auto dem = register_dem(plain_and([&](MapPoint) { return value; }, folder / "in.tif"),
                                  folder / "out.tif");
    ASSERT_TRUE(dem.fill) << value;
    EXPECT_DOUBLE_EQ(dem.fill->value_m, value);
    EXPECT_NEAR(dem.fill->share, 0.25, 1e-9);
    EXPECT_NEAR(dem.fill->step_m, std::abs(50 - value), 2);
    ASSERT_EQ(dem.warnings.size(), 1U);
    EXPECT_NE(dem.warnings[0].find("25 % of the cells are exactly"), std::string::npos)
        << dem.warnings[0];
  }
}

TEST(UndeclaredFill, GroundBetweenIsNoHindrance) {
  // 0 between a coast below and a plain above: neither the lowest value nor the highest.
  const TestFolder folder;
  const auto dem = register_dem(
      plain_and([](MapPoint p) { return p.y > 2050 ? 0 : -3 - 0.01 * p.x; }, folder / "in.tif"),
      folder / "out.tif");
  ASSERT_TRUE(dem.fill);
  EXPECT_DOUBLE_EQ(dem.fill->value_m, 0);
}

TEST(UndeclaredFill, OfTwoFillsOfAMosaicTheSmallerIsTold) {
  const TestFolder folder;
  const auto mosaic = [](MapPoint p) { return p.y > 2030 ? 0.0 : -99.0; };
  const auto dem = register_dem(plain_and(mosaic, folder / "in.tif"), folder / "out.tif");
  ASSERT_TRUE(dem.fill);
  EXPECT_DOUBLE_EQ(dem.fill->value_m, 0);
  ASSERT_EQ(dem.warnings.size(), 2U);
  EXPECT_NE(dem.warnings[1].find("7.5 % of the cells are exactly -99 m"), std::string::npos)
      << dem.warnings[1];
  EXPECT_NE(dem.warnings[1].find("they count as ground"), std::string::npos);
}

TEST(UndeclaredFill, APieceAStepBelowTheGroundIsToldAndStaysGround) {
  const TestFolder folder;
  const auto low_plain = computed(200, 100, {1000, 1, 0, 2100, 0, -1}, [](MapPoint p) {
    return p.x > 1150 ? 0 : 1.3 + 0.1 * std::sin(p.x / 9);
  });
  const auto dem = register_dem(write_geotiff(low_plain, folder / "in.tif"), folder / "out.tif");
  EXPECT_FALSE(dem.fill);
  ASSERT_EQ(dem.warnings.size(), 1U);
  EXPECT_NE(dem.warnings[0].find("25 % of the cells are exactly 0 m and the ground beside"),
            std::string::npos)
      << dem.warnings[0];
}

TEST(UndeclaredFill, ALevelLakeWithShoresIsGround) {
  const TestFolder folder;
  const auto lake = [](MapPoint p) {
    const double shore = 50 + std::sin(1150.0 / 9) + std::sin(p.y / 7);
    return std::max(40.0, shore - 0.6 * (p.x - 1150));
  };
  const auto dem = register_dem(plain_and(lake, folder / "in.tif"), folder / "out.tif");
  EXPECT_FALSE(dem.fill);
  EXPECT_TRUE(dem.warnings.empty());
  EXPECT_DOUBLE_EQ(dem.lowest_m, 40);
}

TEST(UndeclaredFill, AFewCellsAndWholeMetresAreGround) {
  const TestFolder folder;
  const auto few = [](MapPoint p) {
    return p.x < 1152 && p.y < 2004 ? 0 : 50 + std::sin(p.x / 9) + std::sin(p.y / 7);
  };
  EXPECT_FALSE(register_dem(plain_and(few, folder / "a.tif"), folder / "b.tif").fill);
  const auto steps = computed(200, 100, {1000, 1, 0, 2100, 0, -1},
                              [](MapPoint p) { return std::floor((p.x - 1000) / 10); });
  EXPECT_FALSE(register_dem(write_geotiff(steps, folder / "c.tif"), folder / "d.tif").fill);
}

TEST(UndeclaredFill, WhatIsDeclaredOrSaidToBeGroundIsNotLookedFor) {
  const TestFolder folder;
  const auto file = plain_and([](MapPoint) { return 0.0; }, folder / "in.tif");
  DemOptions declared;
  declared.nodata = 0;
  const auto dem = register_dem(file, folder / "a.tif", declared);
  EXPECT_FALSE(dem.fill);
  EXPECT_NEAR(dem.share_with_data, 0.75, 1e-9);
  EXPECT_GT(dem.lowest_m, 45);
  const auto ground = register_dem(file, folder / "b.tif", {}, Fills::all_ground);
  EXPECT_FALSE(ground.fill);
  EXPECT_DOUBLE_EQ(ground.share_with_data, 1);
}

TEST(UndeclaredFill, ASectionOverItIsRefusedWithTheValue) {
  const TestFolder folder;
  const auto dem =
      register_dem(plain_and([](MapPoint) { return 0.0; }, folder / "in.tif"), folder / "out.tif");
  DemOptions options;
  options.missing_m = dem.fill->value_m;
  const Dem registered = Dem::open(folder / "out.tif", options);
  EXPECT_FALSE(registered.sample({1180, 2050}));
  EXPECT_TRUE(registered.sample({1100, 2050}));
  SectionLayout layout;
  layout.lines.push_back({"A", {{1020, 2050}, {1190, 2050}}});
  const auto laid = lay_out_sections(layout, registered);
  ASSERT_EQ(laid.faults.size(), 1U);
  EXPECT_NE(laid.faults[0].message.find("Cells of exactly 0 m count as missing"), std::string::npos)
      << laid.faults[0].message;
}

TEST(UndeclaredFill, IsFoundInFeetToo) {
  const TestFolder folder;
  const auto file = plain_and([](MapPoint) { return -99.0; }, folder / "in.tif");
  DemOptions feet;
  feet.vertical_unit = "ft";
  const auto dem = register_dem(file, folder / "out.tif", feet);
  ASSERT_TRUE(dem.fill);
  EXPECT_NEAR(dem.fill->value_m, -99 * 0.3048, 1e-5);
  DemOptions options;
  options.missing_m = dem.fill->value_m;
  EXPECT_FALSE(Dem::open(folder / "out.tif", options).sample({1180, 2050}));
}

}  // namespace
}  // namespace leda::profiles
