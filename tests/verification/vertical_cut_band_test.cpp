#include <gtest/gtest.h>

#include "tests/verification/record.hpp"
#include "tests/verification/vertical_cut.hpp"

namespace leda::solver::test {
namespace {

template <class Real>
class VerticalCutBand : public ::testing::Test {};
TYPED_TEST_SUITE(VerticalCutBand, BothPrecisions, PrecisionNames);

// validation case vertical_cut_critical_height, both ends of its band, 40 cells over the height.
TYPED_TEST(VerticalCutBand, StandsAt3Point6AndFailsAt4Point1) {
  const bool low = cut_fails<TypeParam>(3.6, 0.5), high = cut_fails<TypeParam>(4.1, 0.5);
  leda::test::record(low ? "fails" : "stands", " at 3.6, ", high ? "fails" : "stands",
                     " at 4.1, 40 cells over the height");
  EXPECT_FALSE(low);
  EXPECT_TRUE(high);
}

}  // namespace
}  // namespace leda::solver::test
