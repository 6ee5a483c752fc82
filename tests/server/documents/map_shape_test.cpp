#include "server/documents/map_shape.hpp"

#include <gtest/gtest.h>

#include "tests/server/documents/read_data.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using Pointers = std::multiset<std::string>;

Pointers line_faults(const char* text) {
  FaultList faults;
  read_map_line(json::parse(text), "/l", 10, faults);
  return test::pointers(faults.take());
}

Pointers ring_faults(const char* text) {
  FaultList faults;
  read_map_polygon(json::parse(text), "/p", 10, faults);
  return test::pointers(faults.take());
}

TEST(MapLine, Sound) {
  EXPECT_EQ(line_faults("[[0, 0], [10, 0], [10, 10], [5, 10]]"), Pointers{});
  EXPECT_DOUBLE_EQ(length_of({{0, 0}, {3, 4}, {3, 10}}), 11);
}

TEST(MapLine, CrossesTouchesAndTurnsBack) {
  EXPECT_EQ(line_faults("[[0, 0], [10, 10], [10, 0], [0, 10]]"), Pointers{"/l"});
  EXPECT_EQ(line_faults("[[0, 0], [10, 0], [10, 10], [5, 0]]"), Pointers{"/l"});
  EXPECT_EQ(line_faults("[[0, 0], [10, 0], [5, 0]]"), Pointers{"/l"});
}

TEST(MapLine, PointsAtFault) {
  EXPECT_EQ(line_faults("[[0, 0]]"), Pointers{"/l"});
  EXPECT_EQ(line_faults("7"), Pointers{"/l"});
  EXPECT_EQ(line_faults("[[0, 0], [0, 0], [1, 1]]"), Pointers{"/l/1"});
  EXPECT_EQ(line_faults("[[0, 0], [1], [2, null], [3, 3]]"), (Pointers{"/l/1", "/l/2/1"}));
  EXPECT_EQ(line_faults("[[0,0],[1,0],[2,0],[3,0],[4,0],[5,0],[6,0],[7,0],[8,0],[9,0],[10,0]]"),
            Pointers{"/l"});
}

TEST(MapLine, WhatItMayHaveBeenIsSaid) {
  const auto told = [](const char* text) {
    FaultList faults;
    read_map_line(json::parse(text), "/l", 10, faults);
    const auto found = faults.take();
    return found.size() == 1 ? found[0].pointer + " " + found[0].message : "no single fault";
  };
  EXPECT_NE(told("[[[0, 0], [1, 1]], [[2, 2], [3, 3]]]").find("a list of 2 lines (a MultiLineSt"),
            std::string::npos);
  EXPECT_NE(told(R"({"type": "LineString", "coordinates": [[0, 0], [1, 1]]})")
                .find("its coordinates alone"),
            std::string::npos);
  const std::string close = told("[[5, 0], [10, 0], [10.0002, 0], [10, 20]]");
  EXPECT_TRUE(close.starts_with("/l/2 (10.0002, 0) lies 0.0002 from the point before it")) << close;
  const std::string crossing = told("[[0, 0], [10, 10], [10, 0], [0, 10]]");
  EXPECT_NE(crossing.find("which starts at (10, 0)"), std::string::npos) << crossing;
}

TEST(MapPolygon, IsClosedAndDoesNotCross) {
  FaultList faults;
  const auto open = read_map_polygon(json::parse("[[0, 0], [4, 0], [4, 4]]"), "/p", 10, faults);
  EXPECT_EQ(open.outer.size(), 4U);
  EXPECT_EQ(open.outer.front(), open.outer.back());
  const auto closed =
      read_map_polygon(json::parse("[[0, 0], [4, 0], [4, 4], [0, 0]]"), "/p", 10, faults);
  EXPECT_EQ(closed.outer, open.outer);
  EXPECT_TRUE(faults.take().empty());
  EXPECT_EQ(ring_faults("[[0, 0], [4, 4], [4, 0], [0, 4]]"), Pointers{"/p"});
  EXPECT_EQ(ring_faults("[[0, 0], [4, 4]]"), Pointers{"/p"});
  EXPECT_EQ(ring_faults("[[0, 0], [4, 4], [0, 0]]"), Pointers{"/p"});
}

}  // namespace
}  // namespace leda::server
