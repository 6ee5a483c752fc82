// Weights: what they carry, and when they are tempered.

#include "solver/hindcast/weights.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace leda::solver {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Weights, AreTheSameWhateverIsAddedToTheirLogarithms) {
  const auto weights = normalized({-2000, -2000 + std::log(3.0), -infinity});
  EXPECT_NEAR(weights[0], 0.25, 1e-12);
  EXPECT_NEAR(weights[1], 0.75, 1e-12);
  EXPECT_EQ(weights[2], 0);
}

TEST(Weights, OfNothingAreNothing) {
  const auto weights = normalized({-infinity, -infinity});
  EXPECT_EQ(weights, (std::vector<double>{0, 0}));
  EXPECT_EQ(effective_members(weights), 0);
}

TEST(Weights, EffectiveMembersAreAllOfEqualOnesAndOneOfASingleOne) {
  EXPECT_NEAR(effective_members({0.25, 0.25, 0.25, 0.25}), 4, 1e-12);
  EXPECT_NEAR(effective_members({0, 1, 0, 0}), 1, 1e-12);
}

/// Weights at the middles of equal slices of a generalized Pareto distribution.
std::vector<double> pareto_logs(double k, int members) {
  std::vector<double> logs;
  for (int i = 0; i < members; ++i) {
    const double above = 1 - (i + 0.5) / members;
    logs.push_back(std::log((std::pow(above, -k) - 1) / k));
  }
  return logs;
}

TEST(ParetoShape, OfParetoWeightsIsTheirs) {
  // Few tail members are drawn towards 0.5 on purpose: 190 of 4000 hardly.
  for (const double k : {0.2, 0.5, 0.7, 1.0}) {
    EXPECT_NEAR(pareto_k(pareto_logs(k, 4000)).value(), k, 0.06) << k;
  }
}

TEST(ParetoShape, IsAsTheFormulasOfItsSourceGiveIt) {
  // Computed apart from this code, from Zhang and Stephens 2009, over weights exp(3 i / 40).
  std::vector<double> logs;
  for (int i = 0; i < 40; ++i) logs.push_back(3.0 * i / 40);
  EXPECT_NEAR(pareto_k(logs).value(), 0.045580987, 1e-6);
}

TEST(ParetoShape, IsBeyondAllBoundsWhereMostMembersHaveNoWeight) {
  std::vector<double> logs(100, -infinity);
  logs[3] = 0;
  logs[4] = -1;
  EXPECT_EQ(pareto_k(logs), infinity);
}

TEST(ParetoShape, IsUnknownOfEqualWeightsAndOfFew) {
  EXPECT_FALSE(pareto_k(std::vector<double>(100, 0.0)));
  EXPECT_FALSE(pareto_k({0, 1, 2, 3, 4, 5}));
}

TEST(ParetoShape, MayBeLargerTheMoreMembersThereAre) {
  EXPECT_NEAR(largest_good_k(100), 0.5, 1e-12);
  EXPECT_NEAR(largest_good_k(1000), 2.0 / 3, 1e-12);
  EXPECT_NEAR(largest_good_k(100'000), 0.7, 1e-12);
}

TEST(Tempering, IsNotNeededWhereEnoughMembersCount) {
  const std::vector<double> prior(64, 0.0), likelihood(64, -3.0);
  EXPECT_EQ(tempering_exponent(prior, likelihood, 32), 1);
}

TEST(Tempering, LeavesAsManyEffectiveMembersAsAsked) {
  std::vector<double> prior(64, 0.0), likelihood;
  for (int i = 0; i < 64; ++i) likelihood.push_back(-0.5 * i * i);
  const double t = tempering_exponent(prior, likelihood, 20);
  EXPECT_GT(t, 0);
  EXPECT_LT(t, 0.1);
  EXPECT_NEAR(effective_members(normalized(tempered(prior, likelihood, t))), 20, 1e-6);
}

TEST(Tempering, NeverTakesBackAMemberThatIsRuledOut) {
  EXPECT_EQ(normalized(tempered({0, 0}, {0, -infinity}, 0)), (std::vector<double>{1, 0}));
}

}  // namespace
}  // namespace leda::solver
