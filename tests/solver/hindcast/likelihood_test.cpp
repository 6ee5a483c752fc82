// What an observation says of a member, against formulas written out and against integrals.

#include "solver/hindcast/likelihood.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace leda::solver {
namespace {

constexpr Discrepancy plain{.sd_ln = 0.3, .correlation = 0.5, .bias_sd_ln = 0};
const Reach silent = Reach::measured(1);

double density(double r, double variance) {
  return std::exp(-0.5 * r * r / variance) / std::sqrt(2 * std::numbers::pi * variance);
}

double below(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

PastSlide only_retrogression(const Observed& observed) { return {"A", observed, {}, 1}; }

double of(const Observed& observed, const Reach& reach, double bias = 0) {
  return std::exp(log_likelihood(only_retrogression(observed), reach, silent, plain, bias));
}

TEST(Likelihood, OfAMeasuredDistanceIsNormalInItsLogarithm) {
  const Observed seen{.value_m = 100, .sd_ln = 0.4, .at_least_m = {}, .at_most_m = {}};
  EXPECT_NEAR(of(seen, Reach::measured(140)), density(std::log(100.0 / 140), 0.25), 1e-12);
  EXPECT_NEAR(of(seen, Reach::measured(140), -0.2), density(std::log(100.0 / 140) + 0.2, 0.25),
              1e-12);
}

TEST(Likelihood, OfABoundIsTheProbabilityBeyondIt) {
  const Observed least{.value_m = {}, .sd_ln = 0, .at_least_m = 100, .at_most_m = {}};
  const Observed most{.value_m = {}, .sd_ln = 0, .at_least_m = {}, .at_most_m = 100};
  const Observed both{.value_m = {}, .sd_ln = 0, .at_least_m = 80, .at_most_m = 120};
  const double z = std::log(100.0 / 140) / 0.3;
  EXPECT_NEAR(of(least, Reach::measured(140)), 1 - below(z), 1e-12);
  EXPECT_NEAR(of(most, Reach::measured(140)), below(z), 1e-12);
  EXPECT_NEAR(of(both, Reach::measured(90)),
              below(std::log(120.0 / 90) / 0.3) - below(std::log(80.0 / 90) / 0.3), 1e-12);
}

TEST(Likelihood, TakesAMemberThatWasCutShortAtTheDistanceNearestToWhatWasSeen) {
  const Observed seen{.value_m = 100, .sd_ln = 0, .at_least_m = {}, .at_most_m = {}};
  EXPECT_NEAR(of(seen, Reach::at_least(60)), density(0, 0.09), 1e-12);
  EXPECT_NEAR(of(seen, Reach::at_least(60), 0.5), density(0, 0.09), 1e-12);
  EXPECT_NEAR(of(seen, Reach::at_least(130)), of(seen, Reach::measured(130)), 1e-12);
  const Observed least{.value_m = {}, .sd_ln = 0, .at_least_m = 500, .at_most_m = {}};
  const Observed most{.value_m = {}, .sd_ln = 0, .at_least_m = {}, .at_most_m = 100};
  EXPECT_EQ(of(least, Reach::at_least(60)), 1);
  EXPECT_NEAR(of(most, Reach::at_least(60)), of(most, Reach::measured(60)), 1e-12);
}

TEST(Likelihood, CountsADistanceBelowWhatTheCellsTellAsThat) {
  PastSlide slide =
      only_retrogression({.value_m = 10, .sd_ln = 0, .at_least_m = {}, .at_most_m = {}});
  slide.least_m = 2;
  EXPECT_EQ(log_likelihood(slide, Reach::measured(0), silent, plain, 0),
            log_likelihood(slide, Reach::measured(2), silent, plain, 0));
}

TEST(Likelihood, OfBothDistancesIsTheirJointDensity) {
  const PastSlide slide{"A", Observed{100, 0.1, {}, {}}, Observed{50, 0.2, {}, {}}, 1};
  const double r1 = std::log(100.0 / 130), r2 = std::log(50.0 / 40);
  const double v1 = 0.09 + 0.01, v2 = 0.09 + 0.04, c = 0.5 * 0.09;
  const double determinant = v1 * v2 - c * c;
  const double square = (v2 * r1 * r1 - 2 * c * r1 * r2 + v1 * r2 * r2) / determinant;
  const double expected = std::exp(-0.5 * square) / (2 * std::numbers::pi * std::sqrt(determinant));
  EXPECT_NEAR(std::exp(log_likelihood(slide, Reach::measured(130), Reach::measured(40), plain, 0)),
              expected, 1e-12);
}

/// By the definition: the common part of the discrepancy is integrated over, the rest is of each.
double by_common_part(const PastSlide& slide, double retrogression_m, double runout_m) {
  const double common = std::sqrt(plain.correlation) * plain.sd_ln;
  const Discrepancy own{std::sqrt(1 - plain.correlation) * plain.sd_ln, 0, 0};
  double sum = 0;
  constexpr double step = 0.01;
  for (double z = -8; z <= 8; z += step) {
    const auto alone = [&](const Observed& observed, double model) {
      return std::exp(
          log_likelihood({"A", observed, {}, 1}, Reach::measured(model), silent, own, common * z));
    };
    sum += step * density(z, 1) * alone(*slide.retrogression, retrogression_m) *
           alone(*slide.runout, runout_m);
  }
  return sum;
}

TEST(Likelihood, OfBoundedDistancesHasTheSameCommonPart) {
  const Observed value{50, 0.2, {}, {}}, least{{}, 0, 100, {}}, most{{}, 0, {}, 60};
  for (const PastSlide& slide : {PastSlide{"A", least, value, 1}, PastSlide{"A", value, least, 1},
                                 PastSlide{"A", least, most, 1}, PastSlide{"A", most, most, 1}}) {
    const double expected = by_common_part(slide, 90, 55);
    EXPECT_NEAR(std::exp(log_likelihood(slide, Reach::measured(90), Reach::measured(55), plain, 0)),
                expected, 1e-6 * expected + 1e-9);
  }
}

}  // namespace
}  // namespace leda::solver
