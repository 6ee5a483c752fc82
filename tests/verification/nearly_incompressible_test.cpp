#include <gtest/gtest.h>

#include <numbers>

#include "tests/verification/record.hpp"
#include "tests/verification/strip_footing.hpp"

namespace leda::solver::test {
namespace {

template <class Real>
class NearlyIncompressible : public ::testing::Test {};
TYPED_TEST_SUITE(NearlyIncompressible, BothPrecisions, PrecisionNames);

// validation case prandtl_strip_footing at Poisson's ratio 0.499: the pressure must not depend on
// how nearly incompressible the clay is (within 10 % of that at 0.45), and stay within -2 / +6 %.
TYPED_TEST(NearlyIncompressible, StripFootingDoesNotLock) {
  const double factor = bearing_capacity_factor<TypeParam>({.cells = 8, .poisson_ratio = 0.499});
  const double softer = bearing_capacity_factor<TypeParam>({.cells = 8, .poisson_ratio = 0.45});
  leda::test::record(factor, " s_u, at 0.45 ", softer, " s_u");
  EXPECT_NEAR(factor, softer, 0.1 * softer);
  EXPECT_GT(factor, 0.98 * (2 + std::numbers::pi));
  EXPECT_LT(factor, 1.06 * (2 + std::numbers::pi));
}

}  // namespace
}  // namespace leda::solver::test
