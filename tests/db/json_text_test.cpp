#include "db/json_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "db/store.hpp"

namespace leda::db {
namespace {

TEST(JsonText, NumbersComeBackBitForBit) {
  const Polyline line = {{0.1 + 0.2, 1.0 / 3.0},
                         {-0.0, 5e-324},
                         {std::numeric_limits<double>::max(), 123456789.123456789}};
  const Polyline back = polyline_from_json(to_json(line));
  EXPECT_EQ(back, line);
  EXPECT_TRUE(std::signbit(back[1].x));
}

TEST(JsonText, WhatIsNotFiniteComesBackAsNaN) {
  const Polyline back = polyline_from_json(
      to_json(Polyline{{std::nan(""), 1}, {std::numeric_limits<double>::infinity(), 2}}));
  ASSERT_EQ(back.size(), 2U);
  EXPECT_TRUE(std::isnan(back[0].x));
  EXPECT_TRUE(std::isnan(back[1].x));
  EXPECT_EQ(back[1].z, 2);
}

TEST(JsonText, AnAreaKeepsItsPolygonsAndHoles) {
  const MapLine square = {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}};
  const MapLine hole = {{2, 2}, {3, 2}, {3, 3}, {2, 2}};
  const std::vector<MapPolygon> area = {{square, {hole, hole}}, {hole, {}}};
  const auto back = area_from_json(to_json(area));
  ASSERT_EQ(back.size(), 2U);
  EXPECT_EQ(back[0].outer, square);
  EXPECT_EQ(back[0].holes, (std::vector<MapLine>{hole, hole}));
  EXPECT_EQ(back[1].outer, hole);
  EXPECT_TRUE(back[1].holes.empty());
  EXPECT_EQ(to_json(std::vector<MapPolygon>{{hole, {}}}),
            "[[[[2.0,2.0],[3.0,2.0],[3.0,3.0],[2.0,2.0]]]]");
}

TEST(JsonText, WarningsOutsideUtf8DoNotThrow) {
  const std::vector<std::string> words = {"Sainte-Monique, \"AA'\"", "broken \xff byte", ""};
  const auto back = words_from_json(to_json(words));
  ASSERT_EQ(back.size(), 3U);
  EXPECT_EQ(back[0], words[0]);
  EXPECT_EQ(back[1], "broken \xef\xbf\xbd byte");
}

TEST(JsonText, DamagedTextIsAStoreError) {
  EXPECT_THROW(polyline_from_json("[[1, 2"), StoreError);
  EXPECT_THROW(words_from_json("[1, 2]"), StoreError);
  EXPECT_THROW(map_line_from_json("[[1]]"), StoreError);
}

}  // namespace
}  // namespace leda::db
