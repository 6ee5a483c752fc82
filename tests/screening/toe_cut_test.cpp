#include "solver/screening/toe_cut.hpp"

#include <gtest/gtest.h>

#include "solver/screening/limit_equilibrium.hpp"
#include "tests/screening/banks.hpp"

namespace leda::solver {
namespace {

//  10 -----.                         10 -----.
//           `.         cut by 4:              `.
//             `.                   4            |
//   0           `------            0            +-------
//      0    10   20    30               0    10 16     30
const Polyline bank{{0, 10}, {10, 10}, {20, 0}, {30, 0}};
const CrestAndToe ends{{10, 10}, {20, 0}};

TEST(ToeCut, StandsWhereTheBankIsThatHigh) {
  const Polyline cut = ground_after_toe_cut(bank, ends, 4);
  const Polyline expected{{0, 10}, {10, 10}, {16, 4}, {16, 0}, {20, 0}, {30, 0}};
  EXPECT_EQ(cut, expected);
}

TEST(ToeCut, OfABankOnTheOtherSideIsTheMirrorImage) {
  const Polyline other{{0, 0}, {10, 0}, {20, 10}, {30, 10}};
  const Polyline cut = ground_after_toe_cut(other, {{20, 10}, {10, 0}}, 4);
  const Polyline expected{{0, 0}, {10, 0}, {14, 0}, {14, 4}, {20, 10}, {30, 10}};
  EXPECT_EQ(cut, expected);
}

TEST(ToeCut, HigherThanTheBankIsHeldToIt) {
  const Polyline cut = ground_after_toe_cut(bank, ends, 25);
  const Polyline expected{{0, 10}, {10, 10}, {10, 0}, {20, 0}, {30, 0}};
  EXPECT_EQ(cut, expected);
}

TEST(ToeCut, TakesTheBumpInFrontAndLeavesTheOtherSide) {
  //  bump up to 3 between face and toe; opposite bank beyond the toe
  const Polyline ground{{0, 10}, {10, 10}, {16, 2}, {17, 3}, {20, 0}, {25, 0}, {30, 6}};
  const Polyline cut = ground_after_toe_cut(ground, {{10, 10}, {20, 0}}, 6);
  EXPECT_DOUBLE_EQ(elevation_at(cut, 17), 0);
  EXPECT_DOUBLE_EQ(elevation_at(cut, 19), 0);
  EXPECT_DOUBLE_EQ(elevation_at(cut, 30), 6);
  EXPECT_DOUBLE_EQ(elevation_at(cut, 12.9), elevation_at(ground, 12.9));
}

TEST(ToeCut, KeepsGroundBelowTheToe) {
  const Polyline ground{{0, 10}, {10, 10}, {20, 0}, {22, -2}, {30, -2}};
  const Polyline cut = ground_after_toe_cut(ground, ends, 4);
  EXPECT_DOUBLE_EQ(elevation_at(cut, 25), -2);
}

TEST(ToeCut, LowersTheFactorOfSafety) {
  const Section s = test::plane_bank(10, 30, 1.5, test::clay_of(17e3, 30e3));
  const double intact = *undrained_bishop(s, s.ground);
  double last = intact;
  for (const double height : {2.0, 4.0, 7.0}) {
    const auto cut = ground_after_toe_cut(s.ground, *bank_of(s), height);
    const double factor = *undrained_bishop(s, cut);
    EXPECT_LT(factor, last);
    last = factor;
  }
}

// Cut to the crest, a bank of uniform clay is a vertical cut.
TEST(ToeCut, OfTheWholeBankIsAVerticalCut) {
  const Section s = test::plane_bank(10, 60, 1.0, test::clay_of(1, 10));
  const auto cut = ground_after_toe_cut(s.ground, *bank_of(s), 10);
  EXPECT_NEAR(*undrained_bishop(s, cut), 3.831, 0.01);
}

// What is left keeps its layers: a crust by thickness does not sink into the cut.
TEST(ToeCut, DoesNotMoveLayers) {
  Section s = test::plane_bank(10, 30, 1.5, test::clay_of(17e3, 20e3));
  s.materials["crust"] = test::clay_of(17e3, 200e3);
  s.layers = {test::layer_of("crust"), test::layer_of("clay")};
  s.layers[0].thickness_m = 2;
  const auto cut = ground_after_toe_cut(s.ground, *bank_of(s), 4);
  Section moved = s;
  moved.ground = cut;
  EXPECT_LT(*undrained_bishop(s, cut), *undrained_bishop(moved, cut));
}

TEST(BankOf, TakesWhatIsGivenAndFindsTheRest) {
  Section s = test::plane_bank(10, 30, 1.5, test::clay_of(17e3, 30e3));
  const auto found = bank_of(s);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->crest, s.ground[1]);
  s.crest = Point{60, 10};
  EXPECT_EQ(bank_of(s)->crest, *s.crest);
  EXPECT_EQ(bank_of(s)->toe, found->toe);
}

}  // namespace
}  // namespace leda::solver
