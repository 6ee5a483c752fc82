#include "profiles/map_geometry.hpp"

#include <gtest/gtest.h>

namespace leda::profiles {
namespace {

TEST(MapGeometry, PositionsAlongALine) {
  const MapLine bent{{0, 0}, {3, 4}, {3, 10}};
  EXPECT_DOUBLE_EQ(length_of(bent), 11);
  EXPECT_EQ(point_at(bent, 8), (MapPoint{3, 7}));
  EXPECT_EQ(point_at(bent, -1), (MapPoint{0, 0}));
  EXPECT_EQ(point_at(bent, 20), (MapPoint{3, 10}));
  EXPECT_EQ(piece_of(bent, 5, 8), (MapLine{{3, 4}, {3, 7}}));
  const Nearest nearest = nearest_on(bent, {5, 7});
  EXPECT_DOUBLE_EQ(nearest.along, 8);
  EXPECT_DOUBLE_EQ(nearest.distance, 2);
}

TEST(MapGeometry, FindsWhereALineCrossesItself) {
  EXPECT_FALSE(first_self_crossing({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_FALSE(first_self_crossing({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}));  // a ring
  EXPECT_EQ(first_self_crossing({{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, -4}}), (MapPoint{2, 0}));
  EXPECT_TRUE(first_self_crossing({{0, 0}, {4, 0}, {1, 0}}));  // turns back over itself
}

TEST(MapGeometry, PolygonsWithHoles) {
  const MapPolygon ring{{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}},
                        {{{3, 3}, {6, 3}, {6, 6}, {3, 6}, {3, 3}}}};
  EXPECT_TRUE(is_inside(ring, {1, 1}));
  EXPECT_FALSE(is_inside(ring, {4, 4}));
  EXPECT_FALSE(is_inside(ring, {10, 4}));
  EXPECT_FALSE(is_inside(MapPolygon{}, {0, 0}));
}

}  // namespace
}  // namespace leda::profiles
