#include "profiles/build_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace leda::profiles {
namespace {

Profile profile() {
  Profile p;
  p.section = "S001";
  p.trace = {{1000, 2000}, {1000, 1694}};
  p.ground = {{0, 21.7}, {183, 21.7}, {220, 5}, {224, 5}, {249, 17}, {306, 17}};
  p.bank = {{183, 21.7}, {220, 5}};
  return p;
}

SoilModel clay(const std::string& name) {
  SoilModel model;
  model.name = name;
  Layer crust, rest;
  crust.material = "crust";
  crust.thickness_m = 2;
  rest.material = "S1";
  model.layers = {crust, rest};
  model.materials = {{"crust", {}}, {"S1", {}}};
  return model;
}

MapPolygon square(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}, {x0, y0}}, {}};
}

TEST(BuildSection, TakesGroundBankSoilAndBase) {
  SoilModel model = clay("everywhere");
  model.water_table = WaterTable{.depth_m = 1.5, .line = {}};
  const BuiltSection built = build_section(profile(), {model});
  ASSERT_TRUE(built.faults.empty());
  EXPECT_EQ(built.section.name, "S001");
  EXPECT_DOUBLE_EQ(built.section.base_m, 0);  // 5 m below the toe
  EXPECT_EQ(built.section.ground, profile().ground);
  EXPECT_EQ(built.section.crest.value(), (Point{183, 21.7}));
  EXPECT_EQ(built.section.toe.value(), (Point{220, 5}));
  EXPECT_EQ(built.section.layers.size(), 2U);
  EXPECT_DOUBLE_EQ(built.section.water_table->depth_m.value(), 1.5);
}

TEST(BuildSection, TheModelAtTheCrestApplies) {
  SoilModel here = clay("here"), elsewhere = clay("elsewhere");
  here.where = {square(900, 1800, 1100, 1850)};  // the crest lies at y = 1817
  elsewhere.where = {square(900, 1850, 1100, 2050)};
  EXPECT_EQ(build_section(profile(), {clay("rest"), elsewhere, here}).soil_model, 2U);
  EXPECT_EQ(build_section(profile(), {elsewhere, clay("rest")}).soil_model, 1U);
  const BuiltSection none = build_section(profile(), {elsewhere});
  ASSERT_EQ(none.faults.size(), 1U);
  EXPECT_NE(none.faults[0].message.find("no soil model applies"), std::string::npos);
}

// The section runs from y = 2000 to y = 1694; its crest lies at y = 1817, x = 183.
TEST(BuildSection, ASectionOverTwoSoilsHasColumns) {
  SoilModel bank = clay("bank"), valley = clay("valley");
  bank.where = {square(900, 1786, 1100, 2050)};
  valley.where = {square(900, 1600, 1100, 1786)};
  valley.materials["S1"].k0 = 0.7;
  const BuiltSection built = build_section(profile(), {valley, bank});
  ASSERT_TRUE(built.faults.empty());
  EXPECT_EQ(built.soil_model, 1U);
  EXPECT_TRUE(built.warnings.empty());
  const Section& s = built.section;
  EXPECT_TRUE(s.layers.empty());
  ASSERT_EQ(s.columns.size(), 2U);
  EXPECT_EQ(s.columns[0].from_m, 0);
  EXPECT_NEAR(s.columns[0].to_m, 214, 0.02);
  EXPECT_EQ(s.columns[1].from_m, s.columns[0].to_m);
  EXPECT_EQ(s.columns[1].to_m, 306);
  EXPECT_EQ(s.columns[0].layers[1].material, "S1");
  EXPECT_EQ(s.columns[1].layers[1].material, "S1 (valley)");
  EXPECT_EQ(s.materials.at("S1 (valley)").k0, 0.7);
  EXPECT_EQ(s.materials.at("S1").k0, bank.materials["S1"].k0);
  EXPECT_EQ(origin_of(built, "/columns/1/layers/0").model, 0U);
  EXPECT_EQ(origin_of(built, "/columns/1/layers/0").pointer, "/layers/0");
  EXPECT_EQ(origin_of(built, "/materials/S1 (valley)/k0").model, 0U);
  EXPECT_EQ(origin_of(built, "/materials/S1 (valley)/k0").pointer, "/materials/S1/k0");
  EXPECT_EQ(origin_of(built, "/materials/S1/k0").model, 1U);
}

TEST(BuildSection, OneSoilOrASliverOfAnotherNeedsNoColumns) {
  SoilModel bank = clay("bank"), rest = clay("rest");
  bank.where = {square(900, 1600, 1100, 2050)};
  EXPECT_TRUE(build_section(profile(), {bank, rest}).section.columns.empty());
  bank.where = {square(900, 1696, 1100, 2050)};
  const BuiltSection sliver = build_section(profile(), {bank, rest});
  EXPECT_TRUE(sliver.section.columns.empty());
  EXPECT_EQ(sliver.section.layers.size(), 2U);
  EXPECT_TRUE(build_section(profile(), {clay("one")}).warnings.empty());
}

TEST(BuildSection, WaterAndBaseOfEachSoil) {
  SoilModel bank = clay("bank"), valley = clay("valley");
  bank.where = {square(900, 1786, 1100, 2050)};
  bank.water_table = WaterTable{.depth_m = 2, .line = {}};
  valley.water_table = WaterTable{.depth_m = 0.5, .line = {}};
  valley.base_m = -3;
  const BuiltSection built = build_section(profile(), {bank, valley});
  EXPECT_EQ(built.section.base_m, 0);
  ASSERT_EQ(built.warnings.size(), 1U);
  EXPECT_NE(built.warnings[0].find("soil 'valley' has it at -3.00 m"), std::string::npos);
  const Polyline& water = built.section.water_table->line;
  EXPECT_NEAR(elevation_at(water, 100), 19.7, 1e-9);
  EXPECT_NEAR(elevation_at(water, 260), 16.5, 1e-9);
  EXPECT_TRUE(std::ranges::is_sorted(water, {}, &Point::x));
}

TEST(BuildSection, GroundWithoutASoilTakesThatBesideItAndSaysSo) {
  SoilModel bank = clay("bank");
  bank.where = {square(900, 1786, 1100, 2050)};
  const BuiltSection built = build_section(profile(), {bank});
  EXPECT_TRUE(built.section.columns.empty());
  ASSERT_EQ(built.warnings.size(), 1U);
  EXPECT_NE(built.warnings[0].find("30 % of it on no soil"), std::string::npos);
}

TEST(BuildSection, OverlappingSoilsAreTold) {
  SoilModel first = clay("first"), second = clay("second");
  first.where = {square(900, 1600, 1100, 2050)};
  second.where = {square(900, 1847, 1100, 2050)};
  const BuiltSection built = build_section(profile(), {first, second, clay("rest")});
  ASSERT_EQ(built.warnings.size(), 1U);
  EXPECT_EQ(built.warnings[0],
            "the polygons of soils 'first' and 'second' overlap on 50 % of the section: there "
            "'first', which stands first, is taken");
}

TEST(BuildSection, ABaseAboveGroundIsAFault) {
  SoilModel model = clay("high");
  model.base_m = 6;
  const BuiltSection built = build_section(profile(), {model});
  ASSERT_EQ(built.faults.size(), 1U);
  EXPECT_EQ(built.faults[0].pointer, "/0/base_m");
  EXPECT_NE(built.faults[0].message.find("lowest ground of section S001 at 5.00 m"),
            std::string::npos);
}

TEST(BuildSection, NamesEveryFaultOfTheModel) {
  SoilModel model = clay("bad");
  model.base_below_toe_m = -1;
  model.layers[0].thickness_m.reset();
  model.layers[1].material = "S2";
  model.layers[1].bottom = {{0, 1}, {10, 1}};
  model.water_table = WaterTable{.depth_m = {}, .line = {{0, 1}, {10, 1}}};
  const BuiltSection built = build_section(profile(), {model});
  std::vector<std::string> pointers;
  for (const Fault& fault : built.faults) pointers.push_back(fault.pointer);
  EXPECT_EQ(pointers,
            (std::vector<std::string>{"/0/layers/0", "/0/layers/1/material", "/0/layers/1/bottom",
                                      "/0/water_table/line", "/0/base_below_toe_m"}));
}

}  // namespace
}  // namespace leda::profiles
