#include "tests/verification/vertical_cut.hpp"

#include <gtest/gtest.h>

#include "tests/verification/record.hpp"

namespace leda::solver::test {
namespace {

template <class Real>
class VerticalCut : public ::testing::Test {};
TYPED_TEST_SUITE(VerticalCut, BothPrecisions, PrecisionNames);

// validation case vertical_cut_critical_height: gamma H / s_u = 3.776 (Lyamin and Sloan 2002,
// Pastor et al. 2009), 3.83 by circles (Taylor 1937); band for a particle method 3.6 to 4.1. With
// 10, 20 and 40 cells over the height the cut fails from 4.43, 4.17 and 4.02: the upper end of the
// band takes 40 cells and minutes (vertical_cut_band_test), here 20 must fail by 4.4.
TYPED_TEST(VerticalCut, StandsAt3Point6AndFailsNotFarAboveTheBandWithCoarseCells) {
  const bool low = cut_fails<TypeParam>(3.6, 1), high = cut_fails<TypeParam>(4.4, 1);
  leda::test::record(low ? "fails" : "stands", " at 3.6, ", high ? "fails" : "stands",
                     " at 4.4, 20 cells over the height");
  EXPECT_FALSE(low);
  EXPECT_TRUE(high);
}

}  // namespace
}  // namespace leda::solver::test
