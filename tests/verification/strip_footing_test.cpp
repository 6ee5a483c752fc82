#include "tests/verification/strip_footing.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/verification/record.hpp"

namespace leda::solver::test {
namespace {

// validation case prandtl_strip_footing (Prandtl 1920): q = (2 + pi) s_u, -2 % / +6 %.
TEST(StripFooting, CarriesPrandtlsPressure) {
  const double factor = bearing_capacity_factor({.cells = 8, .poisson_ratio = 0.45});
  leda::test::record(factor, " s_u with 8 cells under half the strip");
  EXPECT_GT(factor, 0.98 * (2 + std::numbers::pi));
  EXPECT_LT(factor, 1.06 * (2 + std::numbers::pi));
}

}  // namespace
}  // namespace leda::solver::test
