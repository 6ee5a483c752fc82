#include "profiles/build_section.hpp"

#include <gtest/gtest.h>

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

// The section runs from y = 2000 to y = 1694; its crest lies at y = 1817.
TEST(BuildSection, ASectionOverTwoSoilsSaysWhichAndHowFar) {
  SoilModel bank = clay("bank"), valley = clay("valley");
  bank.where = {square(900, 1786, 1100, 2050)};
  valley.where = {square(900, 1600, 1100, 1786)};
  const BuiltSection built = build_section(profile(), {valley, bank});
  EXPECT_EQ(built.soil_model, 1U);
  ASSERT_EQ(built.warnings.size(), 1U);
  EXPECT_EQ(built.warnings[0],
            "soil 'bank', that of the crest, is taken for the whole section, which lies with 30 % "
            "of it on soil 'valley'");
  bank.where = {square(900, 1600, 1100, 2050)};
  EXPECT_TRUE(build_section(profile(), {bank, clay("rest")}).warnings.empty());
  EXPECT_TRUE(build_section(profile(), {clay("one")}).warnings.empty());
}

TEST(BuildSection, GroundWithoutASoilIsTold) {
  SoilModel bank = clay("bank");
  bank.where = {square(900, 1786, 1100, 2050)};
  const BuiltSection built = build_section(profile(), {bank});
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
                                      "/0/base_below_toe_m", "/0/water_table/line"}));
}

}  // namespace
}  // namespace leda::profiles
