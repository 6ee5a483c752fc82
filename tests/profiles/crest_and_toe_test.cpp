#include "solver/section/crest_and_toe.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ranges>

namespace leda {
namespace {

const Polyline sainte_monique{{0, 21.7}, {183, 21.7}, {220, 5}, {224, 5}, {249, 17}, {306, 17}};

Polyline mirrored(const Polyline& ground, double width) {
  Polyline result;
  for (const Point& p : std::views::reverse(ground)) result.push_back({width - p.x, p.z});
  return result;
}

TEST(CrestAndToe, TextbookGround) {
  const auto bank = find_crest_and_toe(sainte_monique);
  ASSERT_TRUE(bank);
  EXPECT_EQ(bank->crest, (Point{183, 21.7}));
  EXPECT_EQ(bank->toe, (Point{220, 5}));
}

TEST(CrestAndToe, MirroredGroundGivesTheMirroredBank) {
  const auto bank = find_crest_and_toe(mirrored(sainte_monique, 306));
  ASSERT_TRUE(bank);
  EXPECT_EQ(bank->crest, (Point{123, 21.7}));
  EXPECT_EQ(bank->toe, (Point{86, 5}));
}

TEST(CrestAndToe, TheOtherBankWhereThatSideIsAskedFor) {
  const auto bank = find_crest_and_toe(sainte_monique, 2.0, Facing::left);
  ASSERT_TRUE(bank);
  EXPECT_EQ(bank->crest, (Point{249, 17}));
  EXPECT_EQ(bank->toe, (Point{224, 5}));
}

TEST(CrestAndToe, FlatGentleAndLowGroundHaveNoBank) {
  EXPECT_FALSE(find_crest_and_toe({{0, 5}, {100, 5}}));
  EXPECT_FALSE(find_crest_and_toe({{0, 9}, {100, 0}}));  // 9 in 100
  EXPECT_FALSE(find_crest_and_toe({{0, 1.9}, {10, 1.9}, {12, 0}, {30, 0}}));
  EXPECT_FALSE(find_crest_and_toe({{0, 5}}));
}

TEST(CrestAndToe, VerticalFace) {
  const auto bank = find_crest_and_toe({{0, 10}, {10, 10}, {10, 0}, {20, 0}});
  ASSERT_TRUE(bank);
  EXPECT_EQ(bank->crest, (Point{10, 10}));
  EXPECT_EQ(bank->toe, (Point{10, 0}));
}

// As Saint-Jude (thesis 4.5): 40 degrees near the toe, 12 to 20 degrees above, then flat.
TEST(CrestAndToe, AFaceThatIsSteepBelowAndGentlerAboveIsOneBank) {
  const auto bank =
      find_crest_and_toe({{0, 28}, {100, 28}, {125, 22.7}, {150, 13.6}, {161.2, 4.2}, {180, 4.2}});
  ASSERT_TRUE(bank);
  EXPECT_EQ(bank->crest, (Point{100, 28}));
  EXPECT_EQ(bank->toe, (Point{161.2, 4.2}));
}

// A plateau that dips 2 % with ripples, a rounded crest, a bench half-way down, talus at 1 in 8,
// and a flood plain with a channel: found within a few metres of where a person puts them.
TEST(CrestAndToe, RoundedGroundWithABenchAndTalus) {
  Polyline ground;
  for (int i = 0; i <= 800; ++i) {
    const double x = 0.5 * i;
    double z = 0;
    if (x < 200) {
      z = 30 - 0.02 * x;
    } else if (x < 220) {
      z = 26 - 0.5 * (x - 200);
    } else if (x < 225) {
      z = 16;
    } else if (x < 245) {
      z = 16 - 0.5 * (x - 225);
    } else if (x < 265) {
      z = 6 - 0.125 * (x - 245);
    } else {
      z = 3.5 - (x > 340 && x < 350 ? 1.5 : 0);
    }
    ground.push_back({x, z + 0.05 * std::sin(3 * x)});
  }
  const auto bank = find_crest_and_toe(ground);
  ASSERT_TRUE(bank);
  EXPECT_NEAR(bank->crest.x, 200, 2);
  EXPECT_NEAR(bank->toe.x, 245, 3);
}

// A vertical face has one x: which side it falls to, the ground beside it tells.
TEST(CrestAndToe, AVerticalFaceFallsToItsLowSide) {
  const Polyline right{{0, 15}, {50, 15}, {50, 5}, {90, 5}};
  const Polyline left{{-90, 5}, {-50, 5}, {-50, 15}, {0, 15}};
  EXPECT_TRUE(falls_right(right, *find_crest_and_toe(right)));
  EXPECT_FALSE(falls_right(left, *find_crest_and_toe(left)));
  // A crest and a toe given at one x of a steep face, without a step.
  const Polyline steep{{0, 15}, {50, 15}, {51, 5}, {90, 5}};
  EXPECT_TRUE(falls_right(steep, {{50.5, 10.04}, {50.5, 9.96}}));
  EXPECT_TRUE(falls_right(steep, {{50, 15}, {51, 5}}));
}

}  // namespace
}  // namespace leda
