// What screening reads off a section: its site, its state at rest, its ground as a path.

#include <gtest/gtest.h>

#include <algorithm>

#include "solver/screening/ground_path.hpp"
#include "solver/screening/site_of_section.hpp"
#include "solver/section/shear_at_rest.hpp"
#include "tests/screening/banks.hpp"

namespace leda::solver {
namespace {

Section layered_bank() {
  Section s = test::plane_bank(10, 30, 1.5, test::clay_of(16e3, 30e3));
  s.materials["crust"] = test::clay_of(18e3, 90e3);
  UrmiSoftening law;
  law.alpha = 1.05;
  law.beta = 2.5;
  law.residual_strain = 2.4;
  law.remolded_strength_Pa = 900;
  s.materials["clay"].softening = Softening{law};
  s.layers = {test::layer_of("crust"), test::layer_of("clay")};
  s.layers[0].thickness_m = 2;
  return s;
}

TEST(SiteOfSection, TakesTheSofteningClayOfTheBank) {
  const auto site = site_of(layered_bank());
  ASSERT_TRUE(site);
  EXPECT_NEAR(site->height_m, 10, 1e-9);
  EXPECT_NEAR(*site->slope_angle_deg, 30, 1e-6);
  EXPECT_NEAR(site->unit_weight, 0.2 * 18e3 + 0.8 * 16e3, 1);
  EXPECT_DOUBLE_EQ(site->peak_strength_Pa, 30e3);
  EXPECT_DOUBLE_EQ(*site->remolded_strength_Pa, 900);
  EXPECT_DOUBLE_EQ(site->softening->beta, 2.5);
  EXPECT_NEAR(*site->peak_strain, 0.01, 1e-12);
}

TEST(SiteOfSection, AveragesAStrengthThatGrowsWithDepth) {
  Section s = layered_bank();
  Strength& strength = s.materials["clay"].peak_strength;
  strength.by = Strength::By::depth;
  strength.table = {{2, 20e3}, {10, 60e3}};
  EXPECT_NEAR(site_of(s)->peak_strength_Pa, 40e3, 200);
}

TEST(SiteOfSection, WithoutABankIsNothing) {
  Section s = layered_bank();
  s.ground = {{0, 5}, {100, 5}};
  s.base_m = 0;
  EXPECT_FALSE(site_of(s));
}

TEST(SectionOfSite, HasTheSitesHeightAngleAndClay) {
  Site site;
  site.height_m = 20;
  site.slope_angle_deg = 35;
  site.unit_weight = 17e3;
  site.peak_strength_Pa = 45e3;
  site.remolded_strength_Pa = 500;
  const auto back = site_of(section_of(site));
  ASSERT_TRUE(back);
  EXPECT_NEAR(back->height_m, 20, 1e-9);
  EXPECT_NEAR(*back->slope_angle_deg, 35, 1e-9);
  EXPECT_NEAR(back->unit_weight, 17e3, 1e-6);
  EXPECT_NEAR(back->peak_strength_Pa, 45e3, 1e-6);
  EXPECT_DOUBLE_EQ(*back->remolded_strength_Pa, 500);
}

TEST(SectionOfSite, OfInsensitiveClayDoesNotSoften) {
  Site site;
  site.height_m = 20;
  site.slope_angle_deg = 35;
  site.unit_weight = 17e3;
  site.peak_strength_Pa = 45e3;
  EXPECT_FALSE(section_of(site).materials.at("clay").softening);
}

// Level ground, water at the surface: tau = (1 - K0)(gamma - gamma_w) z / 2, worst at the base.
TEST(ShearAtRest, OfLevelGroundIsTheClosedForm) {
  Section s = layered_bank();
  s.ground = {{0, 10}, {100, 10}};
  s.base_m = -10;
  s.layers = {test::layer_of("clay")};
  s.water_table = WaterTable{0.0, {}};
  const double shear = 0.25 * (16e3 - water_unit_weight) * 20;
  EXPECT_NEAR(*factor_at_rest(s), 30e3 / shear, 1e-3);
  s.water_table.reset();
  EXPECT_NEAR(*factor_at_rest(s), 30e3 / (0.25 * 16e3 * 20), 1e-3);
}

TEST(ShearAtRest, IsWorseWithLowerWater) {
  Section s = layered_bank();
  s.water_table = WaterTable{1.0, {}};
  EXPECT_LT(*factor_at_rest(s, 2.0), *factor_at_rest(s));
}

TEST(ShearAtRest, LooksAtSofteningGroundOnly) {
  Section s = layered_bank();
  const double with_clay = *factor_at_rest(s);
  s.materials["crust"].peak_strength.constant_Pa = 1;  // yields at once, but does not soften
  EXPECT_DOUBLE_EQ(*factor_at_rest(s), with_clay);
  s.materials["clay"].softening.reset();
  EXPECT_FALSE(factor_at_rest(s));
}

TEST(ShearAtRest, AnIsotropicStateHasNoShear) {
  Section s = layered_bank();
  s.materials["clay"].k0 = 1;
  EXPECT_FALSE(factor_at_rest(s));
}

TEST(GroundPath, WalksDownVerticalFaces) {
  const GroundPath path({{0, 10}, {5, 10}, {5, 0}, {12, 0}});
  EXPECT_DOUBLE_EQ(path.length(), 22);
  EXPECT_EQ(path.at(8), (Point{5, 7}));
  EXPECT_EQ(path.at(-1), (Point{0, 10}));
  EXPECT_EQ(path.at(99), (Point{12, 0}));
}

TEST(GroundPath, StationsGatherAtTheBank) {
  const GroundPath path({{0, 10}, {200, 10}, {220, 0}, {400, 0}});
  const auto stations = path.stations(30);
  EXPECT_TRUE(std::ranges::is_sorted(stations));
  const auto near = std::ranges::count_if(stations, [](double s) { return s > 180 && s < 245; });
  EXPECT_GT(2 * near, std::ssize(stations));
  EXPECT_TRUE(std::ranges::any_of(stations, [](double s) { return std::abs(s - 200) < 0.2; }));
}

TEST(GroundPath, OfLevelGroundHasNoStations) {
  EXPECT_TRUE(GroundPath({{0, 3}, {50, 3}}).stations(30).empty());
}

}  // namespace
}  // namespace leda::solver
