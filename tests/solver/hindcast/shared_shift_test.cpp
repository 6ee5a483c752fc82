#include "solver/hindcast/shared_shift.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace leda::solver {
namespace {

TEST(InputShift, IsNothingWhereWeightsStayed) {
  const std::vector<double> values{3, 1, 2, 4}, same(4, 0.25);
  const InputShift shift = shift_of(values, same, same, 0.9);
  EXPECT_NEAR(shift.shift, 0, 1e-12);
  EXPECT_NEAR(shift.narrowing, 1, 1e-12);
  EXPECT_NEAR(shift.prior.median, 2.5, 1e-12);
  EXPECT_EQ(shift.prior.low, 1);
  EXPECT_EQ(shift.prior.high, 4);
}

TEST(InputShift, ComparesRanksSoThatTheShapeDoesNotMatter) {
  std::vector<double> values, skewed, prior, posterior;
  for (int i = 0; i < 200; ++i) {
    values.push_back(i);
    skewed.push_back(std::exp(0.1 * i));
    prior.push_back(1.0 / 200);
    posterior.push_back(i >= 100 ? 1.0 / 100 : 0);
  }
  const InputShift plain = shift_of(values, prior, posterior, 0.9);
  const InputShift same = shift_of(skewed, prior, posterior, 0.9);
  EXPECT_EQ(plain.shift, same.shift);
  EXPECT_EQ(plain.narrowing, same.narrowing);
  // Of the upper half of a normal distribution.
  EXPECT_NEAR(plain.shift, 0.798, 0.01);
  EXPECT_NEAR(plain.narrowing, 0.603, 0.01);
  EXPECT_NEAR(plain.posterior.median, 149.5, 1e-9);
}

}  // namespace
}  // namespace leda::solver
