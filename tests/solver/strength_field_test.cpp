// The random field against its closed forms, over many seeds: mean 1, cov, a lognormal margin, and
// exp(-2 |dx| / theta_h - 2 |dz| / theta_v) between two points. Tolerances are four standard
// errors.
#include "solver/materials/strength_field.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace leda::solver::test {
namespace {

constexpr RandomField clay{0.3, 20, 2};
constexpr int seeds = 4000;

// Places that the statistics look at, x and z from the first one.
constexpr double lag_x[] = {0, 2, 10, 20};
const std::vector<double> lag_z{5, 5.2, 6, 7};

// Standard normal values at the lattice of the places, [seed][x][z].
using Sample = std::array<std::array<double, 4>, 4>;

double normal_of(double factor) {
  const double s = sd_of_logarithm(clay);
  return std::log(factor) / s + s / 2;
}

const std::vector<Sample>& samples() {
  static const std::vector<Sample> all = [] {
    std::vector<Sample> drawn(seeds);
    for (int seed = 0; seed < seeds; ++seed) {
      const StrengthField field(clay, static_cast<std::uint64_t>(seed), "clay", lag_z);
      for (std::size_t i = 0; i < 4; ++i) {
        const auto factors = field.factors(137 + lag_x[i], 4);
        for (std::size_t k = 0; k < 4; ++k) drawn[std::size_t(seed)][i][k] = normal_of(factors[k]);
      }
    }
    return drawn;
  }();
  return all;
}

template <class Value>
double mean_of(const Value& value) {
  double sum = 0;
  for (const Sample& sample : samples()) sum += value(sample);
  return sum / seeds;
}

TEST(StrengthField, HasMeanOneAndItsCoefficientOfVariation) {
  const auto factor = [](const Sample& s) { return factor_at(clay, s[0][0]); };
  const double mean = mean_of(factor);
  const double square = mean_of([&](const Sample& s) { return factor(s) * factor(s); });
  EXPECT_NEAR(mean, 1, 4 * 0.3 / std::sqrt(seeds));
  EXPECT_NEAR(std::sqrt(square - mean * mean), 0.3, 4 * 0.3 * 0.95 / std::sqrt(seeds));
}

TEST(StrengthField, IsLognormalAtAPoint) {
  for (const auto& [normal, share] : {std::pair{-1.6449, 0.05}, {0.0, 0.5}, {1.2816, 0.9}}) {
    const double below = mean_of([n = normal](const Sample& s) { return s[2][1] < n ? 1.0 : 0.0; });
    EXPECT_NEAR(below, share, 4 * std::sqrt(share * (1 - share) / seeds)) << normal;
  }
}

TEST(StrengthField, IsCorrelatedAsMarkovsSeparableLawSays) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      const double expected = std::exp(-2 * lag_x[i] / 20 - 2 * (lag_z[k] - lag_z[0]) / 2);
      const double found = mean_of([&](const Sample& s) { return s[0][0] * s[i][k]; });
      EXPECT_NEAR(found, expected, 4 * std::sqrt((1 + expected * expected) / seeds))
          << lag_x[i] << " m, " << lag_z[k] - lag_z[0] << " m";
    }
  }
}

// Two points jointly normal would have E[Z1^2 Z2^2] = 1 + 2 rho^2; so few modes miss it by 1 / N.
TEST(StrengthField, IsNearToJointlyNormal) {
  const double rho = std::exp(-0.2);
  const double found =
      mean_of([](const Sample& s) { return s[0][0] * s[0][0] * s[1][0] * s[1][0]; });
  EXPECT_NEAR(found, 1 + 2 * rho * rho, 4 * 6 / std::sqrt(seeds));
}

TEST(StrengthField, OfOneSeedAveragesToOneOverManyScales) {
  const StrengthField field(clay, 1, "clay", {3});
  double sum = 0;
  constexpr int points = 20000;
  for (int i = 0; i < points; ++i) sum += field.factors(i, 1)[0];
  // A line of 1000 scales: variance of the average 1 / 1000 of the point's (Vanmarcke).
  EXPECT_NEAR(sum / points, 1, 4 * 0.3 / std::sqrt(1000));
}

TEST(StrengthField, IsAFunctionOfSeedNameAndPlace) {
  const StrengthField field(clay, 7, "clay", {1, 2, 3});
  const StrengthField elsewhere(clay, 7, "clay", {-4, 2});
  EXPECT_EQ(field.factors(55.5, 3)[1], elsewhere.factors(55.5, 2)[1]);
  EXPECT_EQ(field.factors(55.5, 1)[0], field.factors(55.5, 3)[0]);
  EXPECT_NE(field.factors(55.5, 3)[1], StrengthField(clay, 8, "clay", {2}).factors(55.5, 1)[0]);
  EXPECT_NE(field.factors(55.5, 3)[1], StrengthField(clay, 7, "silt", {2}).factors(55.5, 1)[0]);
}

// Computed beside it by another program, from the formula and the keys alone.
TEST(StrengthField, IsTheSameOnEveryMachine) {
  const auto factors = StrengthField(clay, 12345, "clay", {1, 2.5}).factors(100, 2);
  EXPECT_NEAR(factors[0], 1.3568941848870, 1e-12);
  EXPECT_NEAR(factors[1], 1.2580405733050, 1e-12);
}

}  // namespace
}  // namespace leda::solver::test
