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

TEST(MapGeometry, TheGreatestBendIsMeasuredFromTheWayBetweenTheEnds) {
  EXPECT_DOUBLE_EQ(greatest_bend({{0, 0}, {50, 0}, {100, 0}}).degrees, 0);
  const Bend bend = greatest_bend({{0, 0}, {100, 0}, {100, 100}});
  EXPECT_NEAR(bend.degrees, 45, 1e-9);
  EXPECT_NEAR(greatest_bend({{0, 0}, {90, 0}, {100, 10}, {190, 10}}).degrees, 42, 0.1);
  EXPECT_NEAR(greatest_bend({{0, 0}, {100, 0}, {100, 0.5}, {200, 0.5}}).degrees, 0.14, 0.01)
      << "a hook of half a metre in 200 is none";
}

}  // namespace
}  // namespace leda::profiles
