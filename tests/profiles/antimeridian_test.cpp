#include "profiles/antimeridian.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace leda::profiles {
namespace {

TEST(Antimeridian, MostLinesAreLeftAsTheyAre) {
  const MapLine line{{-72.5, 46}, {-72.4, 46.1}, {-72.3, 46}};
  EXPECT_EQ(cut_at_antimeridian(line), (std::vector<MapLine>{line}));
  EXPECT_EQ(unwrapped(line), line);
  EXPECT_EQ(box_around(line), (MapBox{-72.5, 46, -72.3, 46.1}));
}

TEST(Antimeridian, ALineIsCutInTwo) {
  const auto parts = cut_at_antimeridian(MapLine{{179.5, -17}, {-179.5, -18}});
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0], (MapLine{{179.5, -17}, {180, -17.5}}));
  EXPECT_EQ(parts[1], (MapLine{{-180, -17.5}, {-179.5, -18}}));
  const auto back = cut_at_antimeridian(MapLine{{-179.5, 0}, {179.5, 1}, {-179.5, 2}});
  ASSERT_EQ(back.size(), 3U);
  EXPECT_EQ(back[1], (MapLine{{180, 0.5}, {179.5, 1}, {180, 1.5}}));
}

TEST(Antimeridian, ABoxOverItHasItsWestBeyondItsEast) {
  EXPECT_EQ(box_around({{179.5, -17}, {-179.5, -18}}), (MapBox{179.5, -18, -179.5, -17}));
  EXPECT_EQ(box_around({{-179.5, -17}, {179.5, -18}}), (MapBox{179.5, -18, -179.5, -17}));
}

TEST(Antimeridian, AnAreaIsCutInTwoWithItsHole) {
  const MapPolygon area{{{179, 0}, {-179, 0}, {-179, 1}, {179, 1}, {179, 0}},
                        {{{179.5, 0.4}, {179.5, 0.6}, {-179.5, 0.6}, {-179.5, 0.4}, {179.5, 0.4}}}};
  const auto parts = cut_at_antimeridian(area);
  ASSERT_EQ(parts.size(), 2U);
  for (const MapPolygon& part : parts) {
    double twice = 0, west = 180, east = -180;
    for (std::size_t i = 1; i < part.outer.size(); ++i) {
      const MapPoint a = part.outer[i - 1], b = part.outer[i];
      twice += a.x * b.y - b.x * a.y;
      west = std::min(west, b.x);
      east = std::max(east, b.x);
      EXPECT_LE(std::abs(b.x), 180);
    }
    EXPECT_NEAR(east - west, 1, 1e-9);
    EXPECT_NEAR(twice / 2, 1 - 0.1, 1e-9) << "its half of the hole, and counter-clockwise";
  }
  const MapPolygon home{{{0, 0}, {1, 0}, {1, 1}, {0, 0}}, {}};
  ASSERT_EQ(cut_at_antimeridian(home).size(), 1U);
  EXPECT_EQ(cut_at_antimeridian(home)[0].outer, home.outer);
}

}  // namespace
}  // namespace leda::profiles
