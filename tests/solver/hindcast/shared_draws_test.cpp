// Members of a hindcast: what they share, what they do not, and later waves.

#include "solver/hindcast/shared_draws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

#include "solver/hindcast/weights.hpp"

namespace leda::solver {
namespace {

SharedPlan plan_of(std::size_t members, std::size_t locals = 1) {
  SharedPlan plan;
  plan.inputs = {{"su", Scope::section, Lognormal{1, 0.2}},
                 {"rate", Scope::region, Uniform{0.05, 0.15}},
                 {"slip", Scope::region, Lognormal{4, 0.8}}};
  plan.members = members;
  plan.locals = locals;
  return plan;
}

std::vector<double> equal_weights(std::size_t members) {
  return std::vector<double>(members, 1.0 / static_cast<double>(members));
}

TEST(SharedDraws, AreTheSameAtEverySlideButForLocalInputs) {
  const SharedDraws draws(plan_of(32, 2));
  for (std::size_t m = 0; m < 32; ++m) {
    const auto a = draws.inputs_of({0, m, 0}, "A"), b = draws.inputs_of({1, m, 0}, "B");
    const auto again = draws.inputs_of({0, m, 1}, "A");
    EXPECT_EQ(a[1], b[1]);
    EXPECT_EQ(a[2], again[2]);
    EXPECT_NE(a[0], b[0]);
    EXPECT_NE(a[0], again[0]);
    EXPECT_NE(draws.particle_seed({0, m, 0}, "A"), draws.particle_seed({0, m, 1}, "A"));
  }
}

TEST(SharedDraws, LocalInputsOfTwoSlidesHaveNothingInCommon) {
  const SharedDraws draws(plan_of(256));
  double product = 0;
  for (std::size_t m = 0; m < 256; ++m) {
    product += std::log(draws.inputs_of({0, m, 0}, "A")[0]) / 0.2 *
               std::log(draws.inputs_of({1, m, 0}, "B")[0]) / 0.2;
  }
  EXPECT_NEAR(product / 256, 0, 4.0 / 16);  // 4 standard errors of a correlation
}

TEST(SharedDraws, OfTheFirstWaveFillEverySliceOfThePriorOnce) {
  const SharedDraws draws(plan_of(64));
  std::set<int> slices;
  for (std::size_t m = 0; m < 64; ++m) {
    slices.insert(static_cast<int>((draws.inputs_of({0, m, 0}, "A")[1] - 0.05) / 0.1 * 64));
  }
  EXPECT_EQ(slices.size(), 64U);
  for (const double one : draws.log_prior()) EXPECT_NEAR(one, 0, 1e-12);
}

TEST(SharedDraws, OfLaterWavesLieWithinThePriorAboutTheWeights) {
  SharedDraws draws(plan_of(64));
  std::vector<double> weights(64, 0.0);
  double sum = 0;
  for (std::size_t m = 0; m < 64; ++m) {
    weights[m] = draws.inputs_of({0, m, 0}, "A")[1] > 0.13 ? 1 : 0;
    sum += weights[m];
  }
  for (double& one : weights) one /= sum;
  draws.add_wave(weights);
  ASSERT_EQ(draws.members(), 128U);
  double mean = 0;
  for (std::size_t m = 64; m < 128; ++m) {
    const double rate = draws.inputs_of({0, m, 0}, "A")[1];
    EXPECT_GT(rate, 0.05);
    EXPECT_LT(rate, 0.15);
    mean += rate / 64;
  }
  EXPECT_NEAR(mean, 0.14, 0.005);
}

TEST(SharedDraws, OfAllWavesTogetherStandForThePriorByTheirWeights) {
  SharedDraws draws(plan_of(512));
  std::vector<double> weights(512, 0.0);
  for (std::size_t m = 0; m < 512; ++m) {
    weights[m] = std::exp(-10 * std::abs(draws.inputs_of({0, m, 0}, "A")[1] - 0.13) / 0.05);
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& one : weights) one /= sum;
  draws.add_wave(weights);
  const auto prior = normalized(draws.log_prior());
  double mean = 0, square = 0, ln_slip = 0;
  for (std::size_t m = 0; m < draws.members(); ++m) {
    const auto inputs = draws.inputs_of({0, m, 0}, "A");
    mean += prior[m] * inputs[1];
    square += prior[m] * inputs[1] * inputs[1];
    ln_slip += prior[m] * std::log(inputs[2]);
  }
  EXPECT_NEAR(mean, 0.10, 0.002);
  EXPECT_NEAR(std::sqrt(square - mean * mean), 0.1 / std::sqrt(12.0), 0.002);
  EXPECT_NEAR(ln_slip, std::log(4.0), 0.05);
  // The prior is part of the mixture: no member counts more than there are waves.
  for (const double one : draws.log_prior()) EXPECT_LE(one, std::log(2.0) + 1e-12);
}

TEST(SharedDraws, DependOnTheSeedAlone) {
  SharedDraws one(plan_of(32)), two(plan_of(32));
  one.add_wave(equal_weights(32));
  two.add_wave(equal_weights(32));
  auto other_plan = plan_of(32);
  other_plan.seed = 2;
  const SharedDraws other(other_plan);
  EXPECT_EQ(one.inputs_of({0, 40, 0}, "A"), two.inputs_of({0, 40, 0}, "A"));
  EXPECT_NE(one.inputs_of({0, 4, 0}, "A"), other.inputs_of({0, 4, 0}, "A"));
}

TEST(SharedDraws, ATableOfAnEarlierHindcastIsDrawnRowByRow) {
  SharedPlan plan = plan_of(64);
  plan.inputs[1].distribution = JointSample{"after", {1, 2, 3}, {0.5, 0.25, 0.25}};
  plan.inputs[2].distribution = JointSample{"after", {10, 20, 30}, {0.5, 0.25, 0.25}};
  SharedDraws draws(plan);
  draws.add_wave(equal_weights(64));
  std::size_t first = 0;
  for (std::size_t m = 0; m < draws.members(); ++m) {
    const auto inputs = draws.inputs_of({0, m, 0}, "A");
    EXPECT_EQ(inputs[2], 10 * inputs[1]);
    if (m < 64 && inputs[1] == 1) ++first;
  }
  EXPECT_EQ(first, 32U);
}

}  // namespace
}  // namespace leda::solver
