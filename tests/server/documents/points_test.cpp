#include "server/documents/points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "server/documents/or_null.hpp"

namespace leda::server {
namespace {

TEST(Points, AreListsOfTwoNumbers) {
  EXPECT_EQ(points(MapLine{{1.25, 2}, {3, 4}}).dump(), "[[1.25,2.0],[3.0,4.0]]");
  EXPECT_EQ(points(MapLine{{1.25, 2.75}}, std::round).dump(), "[[1.0,3.0]]");
  EXPECT_EQ(points(Polyline{{1, 2.5}}).dump(), "[[1.0,2.5]]");
  EXPECT_EQ(points(Polyline{}).dump(), "[]");
}

TEST(OrNull, IsNullForWhatIsAbsentOrNoNumber) {
  EXPECT_EQ(or_null(std::optional<double>{}).dump(), "null");
  EXPECT_EQ(or_null(std::optional(1.5)).dump(), "1.5");
  EXPECT_EQ(or_null(std::optional(std::numeric_limits<double>::infinity())).dump(), "null");
  EXPECT_EQ(or_null(std::optional<std::string>("at-rest")).dump(), "\"at-rest\"");
  EXPECT_EQ(or_null(std::optional(std::array{1.0, 2.0})).dump(), "[1.0,2.0]");
}

}  // namespace
}  // namespace leda::server
