#include "solver/ensemble/summary.hpp"

#include <gtest/gtest.h>

#include "tests/solver/ensemble/linear_model.hpp"

namespace leda::solver {
namespace {

std::vector<Member> members_of(const EnsemblePlan& plan,
                               const std::vector<MemberOutcome>& outcomes) {
  const Draws draws = draws_of(plan);
  std::vector<Member> members;
  for (const MemberOutcome& outcome : outcomes) {
    members.push_back({draws.inputs_of({"", "AA'"}, members.size()), outcome, {}, {}});
  }
  return members;
}

/// 64 members, their distances by their number.
template <class Outcome>
EnsembleSummary summary_of(const Outcome& outcome) {
  const auto plan = linear_plan(Method::sobol, 1, 64);
  std::vector<MemberOutcome> outcomes;
  for (std::size_t m = 0; m < 64; ++m) outcomes.push_back(outcome(m));
  return summarize(plan, members_of(plan, outcomes));
}

const ExceedanceQuantile& quantile_of(const EnsembleSummary& summary, double exceedance) {
  for (const auto& q : summary.by_distance.at(Distance::retrogression).quantiles) {
    if (q.exceedance == exceedance) return q;
  }
  throw std::runtime_error("no such exceedance");
}

MemberOutcome censored(double retrogression_m) {
  MemberOutcome outcome = at_rest(retrogression_m, 10);
  outcome.status = RunStatus::left_domain;
  outcome.retrogression = Reach::at_least(retrogression_m);
  return outcome;
}

MemberOutcome unstable() {
  MemberOutcome outcome;
  outcome.status = RunStatus::unstable;
  return outcome;
}

TEST(Ensemble, ALinearModelHasItsExactQuantilesAndIndices) {
  const auto plan = linear_plan(Method::sobol, 1, 1024);
  const auto summary = summarize(plan, linear_members(plan));
  const auto& of = summary.by_distance.at(Distance::retrogression);
  const double variance = deviation_m() * deviation_m();
  for (const auto& quantile : of.quantiles) {
    EXPECT_NEAR(*quantile.distance_m, exact_quantile(quantile.exceedance), 0.6);
    EXPECT_LE(quantile.by_ranks.low_m, exact_quantile(quantile.exceedance));
    EXPECT_GE(*quantile.by_ranks.high_m, exact_quantile(quantile.exceedance));
  }
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    const SobolIndex index = of.indices[i].value();
    EXPECT_NEAR(index.first_order, slopes[i] * slopes[i] / variance, 0.05);
    EXPECT_LT(index.standard_error, 0.1);
    EXPECT_GT(index.standard_error, 0);
  }
  EXPECT_EQ(summary.ending, Ending::half_width);
  EXPECT_DOUBLE_EQ(summary.core_s, 1024);
}

TEST(Ensemble, IndicesOfAnIndicatorFollowTheSameInput) {
  const auto plan = linear_plan(Method::sobol, 1, 512);
  const auto summary = summarize(plan, linear_members(plan));
  const auto& beyond = summary.by_distance.at(Distance::retrogression).beyond;
  ASSERT_EQ(beyond.size(), 5U);
  for (const IndexBeyond& one : beyond) {
    EXPECT_GT(one.indices[0]->first_order, one.indices[2]->first_order) << one.distance_m;
  }
}

TEST(Ensemble, MembersThatAllStandLeaveASmallChanceOfSliding) {
  const auto summary = summary_of([](std::size_t) { return at_rest(0, 0); });
  EXPECT_EQ(summary.by_status.at("stable"), 64U);
  EXPECT_EQ(summary.probability_of_sliding, 0);
  EXPECT_EQ(summary.sliding.low, 0);
  EXPECT_NEAR(summary.sliding.high, 0.056, 0.001);
  EXPECT_EQ(*quantile_of(summary, 0.05).distance_m, 0);
  EXPECT_FALSE(summary.by_distance.at(Distance::retrogression).indices[0]);
  EXPECT_EQ(summary.ending, Ending::half_width);
}

TEST(Ensemble, MembersThatAllSlideDoSo) {
  const auto summary = summary_of([](std::size_t m) { return at_rest(50 + double(m), 10); });
  EXPECT_EQ(summary.probability_of_sliding, 1);
  EXPECT_EQ(summary.sliding.high, 1);
  EXPECT_NEAR(summary.sliding.low, 1 - 0.056, 0.001);
  EXPECT_EQ(*quantile_of(summary, 0.5).distance_m, 50 + 31);
}

TEST(Ensemble, HalfUnstableIsCountedBothWays) {
  const auto summary =
      summary_of([](std::size_t m) { return m < 32 ? unstable() : at_rest(100 + double(m), 10); });
  EXPECT_EQ(summary.by_status.at("unstable"), 32U);
  EXPECT_EQ(summary.probability_of_sliding, 0.75);
  EXPECT_LT(summary.sliding.low, 0.5);
  EXPECT_EQ(summary.sliding.high, 1);
  const auto& most = quantile_of(summary, 0.05);
  EXPECT_FALSE(most.distance_m) << "a quarter may be beyond any distance";
  EXPECT_FALSE(most.by_ranks.high_m);
  const auto& median = quantile_of(summary, 0.5);
  EXPECT_EQ(median.by_ranks.low_m, 0);
  EXPECT_GT(*median.distance_m, 100);
  EXPECT_EQ(summary.ending, Ending::max_members);
}

TEST(Ensemble, HalfCensoredGivesLowerBounds) {
  const auto summary =
      summary_of([](std::size_t m) { return m < 32 ? censored(187) : at_rest(double(m), 10); });
  const auto& most = quantile_of(summary, 0.2);
  EXPECT_EQ(*most.distance_m, 187);
  EXPECT_TRUE(most.is_lower_bound);
  EXPECT_FALSE(most.by_ranks.high_m);
  const auto& least = quantile_of(summary, 0.8);
  EXPECT_FALSE(least.is_lower_bound);
  EXPECT_TRUE(least.by_ranks.high_m);
  EXPECT_EQ(summary.by_distance.at(Distance::retrogression).curve.censored_beyond_m, 187);
  EXPECT_FALSE(summary.by_distance.at(Distance::runout).curve.censored_beyond_m);
}

TEST(Ensemble, ACurveWithAGapSaysSo) {
  const auto summary = summary_of(
      [](std::size_t m) { return m % 2 == 0 ? at_rest(0, 0) : at_rest(100 + double(m), 10); });
  const auto& gaps = summary.by_distance.at(Distance::retrogression).curve.gaps;
  ASSERT_EQ(gaps.size(), 1U);
  EXPECT_EQ(gaps[0].from_m, 0);
  EXPECT_EQ(gaps[0].to_m, 101);
  EXPECT_EQ(gaps[0].probability, 0.5);
  EXPECT_TRUE(quantile_of(summary, 0.5).in_gap);
  EXPECT_FALSE(quantile_of(summary, 0.05).in_gap);
}

TEST(Ensemble, QuantilesNest) {
  const auto summary = summary_of([](std::size_t m) { return at_rest(double(m % 13), 10); });
  double last = 1e9;
  for (const auto& q : summary.by_distance.at(Distance::retrogression).quantiles) {
    EXPECT_LE(*q.distance_m, last);
    last = *q.distance_m;
  }
}

TEST(Chance, IsTheScatterOverSeedsAndItsShareOfAll) {
  const auto chance = chance_share({{10, 12}, {20, 22}, {30}}, {10, 20, 30}).value();
  EXPECT_EQ(chance.members, 2U);
  EXPECT_EQ(chance.runs, 4U);
  EXPECT_DOUBLE_EQ(chance.sd_m, std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(*chance.share, 2 / 100.0);
  EXPECT_FALSE(chance_share({{10}, {20}}, {10, 20}));
}

TEST(CellShift, IsTheMeanOfThePairs) {
  const auto shift = cell_shift({{100, 110}, {50, 55}, {0, 0}, {20, 0}, {0, 30}}).value();
  EXPECT_EQ(shift.pairs, 5U);
  EXPECT_DOUBLE_EQ(shift.mean_m, (10 + 5 + 0 - 20 + 30) / 5.0);
  EXPECT_NEAR(*shift.mean_ln_ratio, std::log(1.1), 1e-12);
  EXPECT_NEAR(*shift.standard_error_ln, 0, 1e-12);
  EXPECT_EQ(shift.both_slid, 2U);
  EXPECT_EQ(shift.only_coarse_slid, 1U);
  EXPECT_EQ(shift.only_fine_slid, 1U);
}

TEST(Stopping, LooksAtDoublingsAlone) {
  EXPECT_TRUE(is_doubling({64, 512}));
  EXPECT_TRUE(is_doubling({64, 64}));
  EXPECT_FALSE(is_doubling({64, 500}));
  EXPECT_FALSE(is_doubling({64, 32}));
  EXPECT_FALSE(is_doubling({0, 64}));
  const StopRule rule;
  EXPECT_EQ(ending(rule, 64, 0.2), Ending::more_members);
  EXPECT_EQ(ending(rule, 128, 0.05), Ending::half_width);
  EXPECT_EQ(ending(rule, 512, 0.06), Ending::max_members);
}

}  // namespace
}  // namespace leda::solver
