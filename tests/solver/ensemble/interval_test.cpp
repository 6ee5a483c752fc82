#include "solver/ensemble/interval.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/solver/ensemble/linear_model.hpp"

namespace leda::solver {
namespace {

constexpr std::size_t repetitions = 1000;

TEST(Interval, ExactOnesAreThoseOfTables) {
  // Clopper and Pearson for 10 of 100 and 0 of 64.
  const Interval ten = exact_interval(10, 100, 0.95);
  EXPECT_NEAR(ten.low, 0.0490, 5e-5);
  EXPECT_NEAR(ten.high, 0.1762, 5e-5);
  EXPECT_EQ(exact_interval(0, 64, 0.95).low, 0);
  EXPECT_NEAR(exact_interval(0, 64, 0.95).high, 1 - std::pow(0.025, 1 / 64.0), 1e-12);
  EXPECT_EQ(exact_interval(64, 64, 0.95).high, 1);
}

TEST(Interval, ReplicatesThatAgreeAreNotBelievedBeyondTheirSize) {
  const Interval agreed = interval_of_replicates({4, 4, 4, 4, 4, 4, 4, 4}, 8, 0.95);
  // t of 7 degrees of freedom, 2.3646, times 1 / (8 sqrt(12 x 8)).
  EXPECT_NEAR(agreed.half_width(), 2.3646 / (8 * std::sqrt(96.0)), 1e-5);
  const Interval rare = interval_of_replicates({0, 0, 1, 0, 0, 0, 0, 0}, 8, 0.95);
  EXPECT_EQ(rare.high, exact_interval(1, 64, 0.95).high);
}

TEST(Interval, RanksAreThoseOfTheExactBinomialDistribution) {
  struct Row {
    std::size_t members;
    double level;
    std::size_t low, high;
  };
  for (const Row& row : {Row{64, 0.05, 1, 9}, Row{64, 0.1, 2, 12}, Row{64, 0.9, 53, 63},
                         Row{128, 0.1, 6, 20}, Row{256, 0.05, 6, 20}, Row{512, 0.5, 234, 279}}) {
    const RankInterval ranks = rank_interval(row.members, row.level, 0.95);
    EXPECT_EQ(ranks.high - ranks.low, row.high - row.low) << row.members << " " << row.level;
  }
  // A two-sided interval of q95 exists from 59 members on.
  EXPECT_EQ(rank_interval(58, 0.95, 0.95).high, 59U);
  EXPECT_LE(rank_interval(59, 0.95, 0.95).high, 59U);
}

/// How often over many repetitions the intervals of an exceedance hold its true value.
struct Coverage {
  double probability = 0, by_ranks = 0, by_replicates = 0;
};

bool holds(const DistanceRange& range, double value) {
  return range.low_m <= value && value <= range.high_m.value_or(value);
}

Coverage coverage(Method method, std::size_t members, double exceedance) {
  const double truth = exact_quantile(exceedance);
  Coverage share;
  for (std::size_t seed = 1; seed <= repetitions; ++seed) {
    const EnsemblePlan plan = linear_plan(method, seed, members);
    std::vector<Reach> reaches;
    for (const Member& member : linear_members(plan)) {
      reaches.push_back(member.outcome.retrogression);
    }
    const auto curve = exceedance_curve(reaches, plan.replication());
    const auto quantile = exceedance_quantile(reaches, curve, exceedance, plan.replication());
    // The step of the curve that the true distance stands on.
    const auto above = std::ranges::find_if(
        curve.points, [&](const CurvePoint& point) { return point.distance_m > truth; });
    const Interval& interval = std::prev(above)->interval;
    const double one = 1.0 / double(repetitions);
    if (interval.low <= exceedance && exceedance <= interval.high) share.probability += one;
    if (holds(quantile.by_ranks, truth)) share.by_ranks += one;
    if (holds(quantile.by_replicates, truth)) share.by_replicates += one;
  }
  return share;
}

TEST(Coverage, OfIndependentMembersIsWhatWasAsked) {
  for (const double exceedance : {0.5, 0.05}) {
    const Coverage share = coverage(Method::random, 128, exceedance);
    EXPECT_GE(share.probability, 0.94) << exceedance;
    EXPECT_GE(share.by_ranks, 0.94) << exceedance;
    EXPECT_GE(share.by_replicates, 0.94) << exceedance;
    EXPECT_LE(share.by_ranks, 0.99) << exceedance << ": wider than need be";
  }
}

TEST(Coverage, OfNetsAndHypercubesIsNearlySo) {
  for (const Method method : {Method::sobol, Method::latin}) {
    for (const double exceedance : {0.5, 0.05}) {
      const Coverage share = coverage(method, 128, exceedance);
      EXPECT_GE(share.probability, 0.91) << to_string(method) << " " << exceedance;
      EXPECT_GE(share.by_replicates, 0.91) << to_string(method) << " " << exceedance;
      EXPECT_GE(share.by_ranks, 0.95) << to_string(method) << " " << exceedance << ": not safe";
    }
  }
}

TEST(Coverage, NetsAreNarrowerThanChance) {
  double net = 0, chance = 0;
  for (std::size_t seed = 1; seed <= 50; ++seed) {
    const auto width = [&](Method method) {
      const auto plan = linear_plan(method, seed, 256);
      const auto summary = summarize(plan, linear_members(plan));
      const auto& range =
          summary.by_distance.at(Distance::retrogression).quantiles.at(2).by_replicates;
      return *range.high_m - range.low_m;
    };
    net += width(Method::sobol);
    chance += width(Method::random);
  }
  EXPECT_LT(net, 0.6 * chance);
}

}  // namespace
}  // namespace leda::solver
