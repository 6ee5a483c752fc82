#include <gtest/gtest.h>

#include "tests/verification/vertical_cut.hpp"

namespace leda::solver::test {
namespace {

// validation case vertical_cut_critical_height, both ends of its band, 40 cells over the height.
TEST(VerticalCutBand, StandsAt3Point6AndFailsAt4Point1) {
  EXPECT_FALSE(cut_fails(3.6, 0.5));
  EXPECT_TRUE(cut_fails(4.1, 0.5));
}

}  // namespace
}  // namespace leda::solver::test
