// Slides whose answer is known: ln f = 4 + x theta + phi with normal theta (shared) and phi (of
// each slide), so that everything after the slides were seen is normal too.

#include <gtest/gtest.h>

#include <cmath>

#include "solver/hindcast/hindcast.hpp"

namespace leda::solver {
namespace {

struct LinearSlide {
  double x = 1, seen_ln = 4;
};

constexpr double discrepancy_sd = 0.3, survey_sd = 0.1, level = 4;
const std::vector<LinearSlide> four{{1, 4.5}, {0.6, 4.1}, {1.4, 4.9}, {-0.5, 3.9}};

UncertainInput standard_normal(const char* name, Scope scope) { return {name, scope, Normal{}}; }

HindcastPlan linear_plan(const std::vector<LinearSlide>& slides, std::size_t members) {
  HindcastPlan plan;
  plan.draws.inputs = {standard_normal("theta", Scope::region),
                       standard_normal("idle", Scope::region),
                       standard_normal("phi", Scope::section)};
  plan.draws.members = members;
  plan.discrepancy = {discrepancy_sd, 0.5, 0};
  plan.waves = 1;
  for (const LinearSlide& s : slides) {
    plan.slides.push_back({"slide " + std::to_string(plan.slides.size()),
                           Observed{std::exp(s.seen_ln), survey_sd, {}, {}},
                           {},
                           1e-3});
  }
  return plan;
}

MemberOutcome slid_by(const Reach& reach) {
  MemberOutcome outcome;
  outcome.status = RunStatus::at_rest;
  outcome.retrogression = outcome.runout = reach;
  return outcome;
}

/// @param local_sd of phi's share
SlideOutcomes run_linear(const HindcastPlan& plan, const SharedDraws& draws,
                         const std::vector<LinearSlide>& slides, double local_sd = 0) {
  SlideOutcomes outcomes(slides.size());
  for (std::size_t e = 0; e < slides.size(); ++e) {
    for (std::size_t m = 0; m < draws.members(); ++m) {
      std::vector<MemberOutcome> locals;
      for (std::size_t k = 0; k < plan.draws.locals; ++k) {
        const auto inputs = draws.inputs_of({e, m, k}, plan.slides[e].name);
        const double ln = level + slides[e].x * inputs[0] + local_sd * inputs[2];
        locals.push_back(slid_by(Reach::measured(std::exp(ln))));
      }
      outcomes[e].push_back(std::move(locals));
    }
  }
  return outcomes;
}

struct Normal1 {
  double mean = 0, variance = 1;
};

/// theta after all slides but one, in closed form.
Normal1 theta_after(const std::vector<LinearSlide>& slides, double variance, std::size_t without) {
  double precision = 1, sum = 0;
  for (std::size_t e = 0; e < slides.size(); ++e) {
    if (e == without) continue;
    precision += slides[e].x * slides[e].x / variance;
    sum += slides[e].x * (slides[e].seen_ln - level) / variance;
  }
  return {sum / precision, 1 / precision};
}

Normal1 weighted_theta(const HindcastPlan& plan, const SharedDraws& draws,
                       const std::vector<double>& weights) {
  double mean = 0, square = 0;
  for (std::size_t m = 0; m < weights.size(); ++m) {
    const double theta = draws.inputs_of({0, m, 0}, plan.slides[0].name)[0];
    mean += weights[m] * theta;
    square += weights[m] * theta * theta;
  }
  return {mean, square - mean * mean};
}

constexpr double noise = discrepancy_sd * discrepancy_sd + survey_sd * survey_sd;

TEST(LinearSlides, SharedInputIsAsInClosedForm) {
  const auto plan = linear_plan(four, 1024);
  const SharedDraws draws(plan.draws);
  const auto summary = summarize(plan, draws, run_linear(plan, draws, four));
  const Normal1 exact = theta_after(four, noise, four.size());
  const Normal1 found = weighted_theta(plan, draws, summary.posterior.values);
  EXPECT_NEAR(found.mean, exact.mean, 0.01);
  EXPECT_NEAR(found.variance, exact.variance, 0.05 * exact.variance);
  ASSERT_EQ(summary.inputs.size(), 2U);
  EXPECT_NEAR(summary.inputs[0].shift, exact.mean, 0.02);
  EXPECT_NEAR(summary.inputs[0].narrowing, std::sqrt(exact.variance), 0.02);
  // What no slide depends on moves by chance alone.
  EXPECT_NEAR(summary.inputs[1].shift, 0, 0.1);
  EXPECT_NEAR(summary.inputs[1].narrowing, 1, 0.1);
  EXPECT_EQ(summary.exponent, 1);
  EXPECT_TRUE(summary.doubts.empty());
}

TEST(LinearSlides, EachIsPredictedFromTheOthersAsInClosedForm) {
  const auto plan = linear_plan(four, 1024);
  const SharedDraws draws(plan.draws);
  const auto summary = summarize(plan, draws, run_linear(plan, draws, four));
  std::size_t hits = 0;
  for (std::size_t e = 0; e < four.size(); ++e) {
    const Normal1 theta = theta_after(four, noise, e);
    const double mean = level + four[e].x * theta.mean;
    const double sd = std::sqrt(four[e].x * four[e].x * theta.variance + noise);
    const auto& p = summary.slides[e].by_distance.at(Distance::retrogression);
    EXPECT_NEAR(std::log(p.median_m), mean, 0.02);
    EXPECT_NEAR(std::log(p.low_m), mean - 1.645 * sd, 0.03);
    EXPECT_NEAR(std::log(p.high_m.value()), mean + 1.645 * sd, 0.03);
    EXPECT_NEAR(p.pit.value(), 0.5 * std::erfc(-(four[e].seen_ln - mean) / sd / std::sqrt(2.0)),
                0.02);
    EXPECT_EQ(p.hit.value(), std::abs(four[e].seen_ln - mean) < 1.645 * sd);
    hits += *p.hit ? 1 : 0;
  }
  const auto& score = summary.scores.at(Distance::retrogression);
  EXPECT_EQ(score.coverage.hits, hits);
  EXPECT_EQ(score.coverage.of, 4U);
  EXPECT_FALSE(summary.scores.contains(Distance::runout));
  EXPECT_GT(score.sharpness.value(), std::exp(2 * 1.645 * std::sqrt(noise)) - 0.05);
  EXPECT_TRUE(score.mean_crps_of_rule_ln);
}

TEST(LinearSlides, LocalInputsAreIntegratedOut) {
  auto plan = linear_plan(four, 512);
  plan.draws.locals = 8;
  const SharedDraws draws(plan.draws);
  constexpr double local_sd = 0.3;
  const auto summary = summarize(plan, draws, run_linear(plan, draws, four, local_sd));
  const Normal1 exact = theta_after(four, noise + local_sd * local_sd, four.size());
  const Normal1 found = weighted_theta(plan, draws, summary.posterior.values);
  EXPECT_NEAR(found.mean, exact.mean, 0.03);
  EXPECT_NEAR(found.variance, exact.variance, 0.15 * exact.variance);
}

TEST(LinearSlides, ACommonBiasTakesItsShareOfWhatIsAmiss) {
  auto plan = linear_plan(four, 512);
  plan.discrepancy.bias_sd_ln = 0.5;
  const SharedDraws draws(plan.draws);
  const auto summary = summarize(plan, draws, run_linear(plan, draws, four));
  // Precision matrix of (theta, b).
  double tt = 1, tb = 0, bb = 1 / 0.25, t = 0, b = 0;
  for (const LinearSlide& s : four) {
    tt += s.x * s.x / noise;
    tb += s.x / noise;
    bb += 1 / noise;
    t += s.x * (s.seen_ln - level) / noise;
    b += (s.seen_ln - level) / noise;
  }
  const double determinant = tt * bb - tb * tb;
  const Normal1 found = weighted_theta(plan, draws, summary.posterior.values);
  EXPECT_NEAR(found.mean, (bb * t - tb * b) / determinant, 0.02);
  EXPECT_NEAR(found.variance, bb / determinant, 0.05 * bb / determinant);
  EXPECT_NEAR(summary.bias_ln, (tt * b - tb * t) / determinant, 0.02);
  EXPECT_NEAR(summary.bias_sd_ln, std::sqrt(tt / determinant), 0.02);
}

TEST(LinearSlides, FurtherWavesFindWhatTheFirstOneHardlyHolds) {
  std::vector<LinearSlide> far{{1, 6.2}, {1, 6.3}};
  auto plan = linear_plan(far, 64);
  plan.discrepancy.sd_ln = 0.05;
  plan.waves = 4;
  SharedDraws draws(plan.draws);
  const auto first = summarize(plan, draws, run_linear(plan, draws, far));
  EXPECT_LT(first.full.effective, 4);
  EXPECT_LT(first.exponent, 1);
  EXPECT_NEAR(first.posterior.effective, plan.least_effective, 1e-6);
  EXPECT_FALSE(first.doubts.empty());
  while (const auto weights = next_wave(plan, draws, run_linear(plan, draws, far))) {
    draws.add_wave(*weights);
  }
  const auto last = summarize(plan, draws, run_linear(plan, draws, far));
  const Normal1 exact = theta_after(far, 0.05 * 0.05 + survey_sd * survey_sd, far.size());
  const Normal1 found = weighted_theta(plan, draws, last.posterior.values);
  EXPECT_EQ(last.exponent, 1);
  EXPECT_GE(last.waves, 2U);
  EXPECT_LE(last.waves, 4U);
  EXPECT_GE(last.full.effective, plan.least_effective);
  EXPECT_NEAR(found.mean, exact.mean, 0.03);
  EXPECT_NEAR(found.variance, exact.variance, 0.4 * exact.variance);
}

TEST(LinearSlides, AMemberThatDoesNotSlideCannotBeTheirs) {
  const auto plan = linear_plan(four, 64);
  const SharedDraws draws(plan.draws);
  auto outcomes = run_linear(plan, draws, four);
  outcomes[1][7][0] = slid_by(Reach::measured(0));
  outcomes[2][8][0] = MemberOutcome{};
  const auto summary = summarize(plan, draws, outcomes);
  EXPECT_EQ(summary.posterior.values[7], 0);
  EXPECT_EQ(summary.posterior.values[8], 0);
  EXPECT_GT(summary.slides[1].others.values[7], 0);
  EXPECT_EQ(summary.slides[1].runs.at("at-rest"), 1U);
  EXPECT_EQ(summary.slides[1].runs.at("slid"), 63U);
  EXPECT_NEAR(summary.slides[1].slides_prior, 63.0 / 64, 1e-12);
  EXPECT_EQ(summary.slides[2].runs.at("no-result"), 1U);
}

TEST(LinearSlides, WhereNoMemberSlidNothingIsSaid) {
  const auto plan = linear_plan(four, 64);
  const SharedDraws draws(plan.draws);
  auto outcomes = run_linear(plan, draws, four);
  for (auto& locals : outcomes[0]) locals[0] = slid_by(Reach::measured(0));
  const auto summary = summarize(plan, draws, outcomes);
  EXPECT_EQ(summary.full.effective, 0);
  EXPECT_EQ(summary.doubts.size(), 1U);
  EXPECT_TRUE(summary.inputs.empty());
  EXPECT_FALSE(next_wave(plan, draws, outcomes));
  // The others still say what they expect there, of members that slid: none did.
  EXPECT_TRUE(summary.slides[0].by_distance.empty());
  EXPECT_GT(summary.slides[0].others.effective, 0);
}

TEST(LinearSlides, MembersThatWereCutShortLeaveTheUpperEndOpen) {
  const auto plan = linear_plan(four, 256);
  const SharedDraws draws(plan.draws);
  auto outcomes = run_linear(plan, draws, four);
  for (std::size_t m = 0; m < 256; m += 3) {
    const double bound = outcomes[0][m][0].retrogression.low_m;
    outcomes[0][m][0] = slid_by(Reach::at_least(bound));
  }
  const auto summary = summarize(plan, draws, outcomes);
  const auto& p = summary.slides[0].by_distance.at(Distance::retrogression);
  EXPECT_FALSE(p.high_m);
  EXPECT_NEAR(p.beyond, 1.0 / 3, 0.1);
  EXPECT_TRUE(std::isinf(p.width_ln));
  EXPECT_GT(summary.cut_short, 0.2);
  ASSERT_EQ(summary.doubts.size(), 1U);
  EXPECT_NE(summary.doubts[0].find("cut short"), std::string::npos);
}

}  // namespace
}  // namespace leda::solver
