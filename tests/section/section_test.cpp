#include "solver/section/section.hpp"

#include <gtest/gtest.h>

#include "tests/section/bank.hpp"

namespace leda {
namespace {

TEST(LayerBottom, FollowsThicknessElevationAndBase) {
  const Section s = test::bank();
  EXPECT_DOUBLE_EQ(layer_bottom(s, s.layers[0], 20), 18);
  EXPECT_DOUBLE_EQ(layer_bottom(s, s.layers[0], 55), 10.5);
  EXPECT_DOUBLE_EQ(layer_bottom(s, s.layers[1], 20), 5);
  EXPECT_DOUBLE_EQ(layer_bottom(s, s.layers[2], 20), 0);
}

TEST(LayerBottom, StaysBetweenBaseAndGround) {
  Section s = test::bank();
  s.layers[0].thickness_m = 100;
  s.layers[1].bottom_m = 12;
  EXPECT_DOUBLE_EQ(layer_bottom(s, s.layers[0], 20), 0);
  EXPECT_DOUBLE_EQ(layer_bottom(s, s.layers[1], 90), 5);
}

TEST(LayerBottom, FollowsALineAndTheToe) {
  Section s = test::bank();
  s.layers[1].bottom_m.reset();
  s.layers[1].bottom = {{0, 8}, {100, 3}};
  EXPECT_DOUBLE_EQ(layer_bottom(s, s.layers[1], 50), 5.5);
  s.layers[1].bottom.clear();
  s.layers[1].bottom_below_toe_m = 2;
  EXPECT_DOUBLE_EQ(layer_bottom(s, s.layers[1], 20), 3);  // the toe is found at (70, 5)
  s.toe = Point{60, 10};
  EXPECT_DOUBLE_EQ(layer_bottom(s, s.layers[1], 20), 8);
}

TEST(LayerAt, TakesTheTopmostLayerWhoseBottomIsBelow) {
  const Section s = test::bank();
  EXPECT_EQ(&layer_at(s, {20, 19}), s.layers.data());
  EXPECT_EQ(&layer_at(s, {20, 10}), s.layers.data() + 1);
  EXPECT_EQ(&layer_at(s, {20, 1}), s.layers.data() + 2);
  // In the valley the crust reaches below the clay's bottom: the clay thins out there.
  EXPECT_EQ(&layer_at(s, {90, 4}), s.layers.data());
  EXPECT_EQ(&layer_at(s, {90, 2}), s.layers.data() + 2);
}

TEST(Columns, ABorderBelongsToTheRightAndTheOuterOnesGoOn) {
  Section s = test::bank();
  s.columns = {{0, 60, {test::layer("crust")}}, {60, 100, {test::layer("clay")}}};
  s.layers.clear();
  EXPECT_EQ(layer_lists(s), 2U);
  EXPECT_EQ(layer_at(s, {59.9, 2}).material, "crust");
  EXPECT_EQ(layer_at(s, {60, 2}).material, "clay");
  EXPECT_EQ(layer_at(s, {-5, 2}).material, "crust");
  EXPECT_EQ(layer_at(s, {105, 2}).material, "clay");
}

TEST(PorePressure, GrowsBelowTheWaterTableOnly) {
  Section s = test::bank();
  EXPECT_DOUBLE_EQ(pore_pressure(s, {20, 10}), 98100);
  s.water_table = WaterTable{4.0, {}};
  EXPECT_DOUBLE_EQ(pore_pressure(s, {20, 10}), 6 * 9810);
  EXPECT_DOUBLE_EQ(pore_pressure(s, {20, 18}), 0);
  s.water_table = WaterTable{std::nullopt, {{0, 15}, {100, 5}}};
  EXPECT_DOUBLE_EQ(pore_pressure(s, {50, 4}), 6 * 9810);
  s.water_table.reset();
  EXPECT_DOUBLE_EQ(pore_pressure(s, {20, 1}), 0);
}

}  // namespace
}  // namespace leda
