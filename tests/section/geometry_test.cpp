#include "solver/section/geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace leda {
namespace {

TEST(ElevationAt, IsStraightBetweenPointsAndHeldBeyondTheEnds) {
  const Polyline line{{0, 10}, {10, 20}, {20, 0}};
  EXPECT_DOUBLE_EQ(elevation_at(line, 2.5), 12.5);
  EXPECT_DOUBLE_EQ(elevation_at(line, 10), 20);
  EXPECT_DOUBLE_EQ(elevation_at(line, 15), 10);
  EXPECT_DOUBLE_EQ(elevation_at(line, -5), 10);
  EXPECT_DOUBLE_EQ(elevation_at(line, 25), 0);
}

TEST(ElevationAt, TakesTheHigherSideOfAVerticalStep) {
  const Polyline falls{{0, 10}, {5, 10}, {5, 2}, {9, 2}};
  const Polyline rises{{0, 2}, {5, 2}, {5, 10}, {9, 10}};
  EXPECT_DOUBLE_EQ(elevation_at(falls, 5), 10);
  EXPECT_DOUBLE_EQ(elevation_at(rises, 5), 10);
  EXPECT_DOUBLE_EQ(elevation_at(falls, 5.001), 2);
  EXPECT_DOUBLE_EQ(elevation_at(rises, 4.999), 2);
}

TEST(FirstFault, NamesThePoint) {
  EXPECT_FALSE(first_fault({{0, 1}, {0, 2}, {3, 1}}));
  EXPECT_EQ(first_fault({{0, 1}, {2, 2}, {1, 1}})->point, 2U);
  EXPECT_EQ(first_fault({{0, 1}, {NAN, 2}, {3, 1}})->point, 1U);
  EXPECT_EQ(first_fault({{0, 1}, {1, INFINITY}})->point, 1U);
  EXPECT_TRUE(first_fault({{0, 1}}));
  EXPECT_TRUE(first_fault({}));
}

TEST(IsInside, FollowsAConcavePolygon) {
  //  4 +--+  +--+
  //    |  |  |  |
  //  2 |  +--+  |
  //  0 +--------+
  //    0  3  6  9
  const Polyline u{{0, 0}, {9, 0}, {9, 4}, {6, 4}, {6, 2}, {3, 2}, {3, 4}, {0, 4}};
  EXPECT_TRUE(is_inside(u, {1, 3}));
  EXPECT_TRUE(is_inside(u, {4.5, 1}));
  EXPECT_TRUE(is_inside(u, {8, 3}));
  EXPECT_FALSE(is_inside(u, {4.5, 3}));
  EXPECT_FALSE(is_inside(u, {10, 1}));
  EXPECT_FALSE(is_inside({}, {0, 0}));
}

}  // namespace
}  // namespace leda
