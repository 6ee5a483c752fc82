#include "tests/verification/strip_footing.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/verification/record.hpp"

namespace leda::solver::test {
namespace {

template <class Real>
class StripFooting : public ::testing::Test {};
TYPED_TEST_SUITE(StripFooting, BothPrecisions, PrecisionNames);

// validation case prandtl_strip_footing (Prandtl 1920): q = (2 + pi) s_u, -2 % / +6 %.
TYPED_TEST(StripFooting, CarriesPrandtlsPressure) {
  const double factor = bearing_capacity_factor<TypeParam>({.cells = 8, .poisson_ratio = 0.45});
  leda::test::record(factor, " s_u with 8 cells under half the strip");
  EXPECT_GT(factor, 0.98 * (2 + std::numbers::pi));
  EXPECT_LT(factor, 1.06 * (2 + std::numbers::pi));
}

// Moduli are lower at the free edges alone, and no strength is: the same pressure, within 2 %.
TYPED_TEST(StripFooting, LongStepsCarryTheSamePressure) {
  const double factor = bearing_capacity_factor<TypeParam>({.time_step_factor = 0.95});
  const double plain = bearing_capacity_factor<TypeParam>({});
  leda::test::record(factor, " s_u, in steps of 0.4 ", plain, " s_u");
  EXPECT_NEAR(factor, plain, 0.02 * plain);
  EXPECT_GT(factor, 0.98 * (2 + std::numbers::pi));
  EXPECT_LT(factor, 1.06 * (2 + std::numbers::pi));
}

}  // namespace
}  // namespace leda::solver::test
