#include "solver/ensemble/distribution.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace leda::solver {
namespace {

/// Mean and deviation by the midpoints of many equal shares.
std::pair<double, double> moments(const Distribution& d) {
  constexpr int shares = 200'000;
  double sum = 0, squares = 0;
  for (int i = 0; i < shares; ++i) {
    const double x = quantile(d, (i + 0.5) / shares);
    sum += x / shares;
    squares += x * x / shares;
  }
  return {sum, std::sqrt(squares - sum * sum)};
}

std::vector<Fault> faults_of(const Distribution& d) {
  FaultList list;
  check(d, "", list);
  return list.take();
}

TEST(Distribution, ALognormalOneHasItsArithmeticMeanAndCov) {
  const auto [mean, sd] = moments(lognormal_of_mean(40.5, 0.3));
  EXPECT_NEAR(mean, 40.5, 0.01);
  EXPECT_NEAR(sd, 0.3 * 40.5, 0.05);
  EXPECT_DOUBLE_EQ(quantile(Lognormal{7, 0.4}, 0.5), 7);
}

TEST(Distribution, ANormalOneHasItsTableValues) {
  EXPECT_NEAR(quantile(Normal{10, 2, {}, {}}, 0.975), 10 + 2 * 1.959963984540054, 1e-12);
  EXPECT_NEAR(quantile(Normal{10, 2, {}, {}}, 1e-12), 10 - 2 * 7.034483825, 1e-6);
}

TEST(Distribution, ATruncatedNormalOneStaysInsideAndIsHalvedByItsMedian) {
  const Normal folded{0, 1, 0.0, {}};
  EXPECT_NEAR(quantile(folded, 0.5), 0.6744897501960817, 1e-12);
  EXPECT_GE(quantile(folded, 1e-300), 0);
  const Normal far{0, 1, 8.0, 9.0};  // where 1 - p has lost all its digits
  EXPECT_GE(quantile(far, 0.5), 8);
  EXPECT_LT(quantile(far, 0.5), 8.2);
  EXPECT_LT(quantile(far, 0.1), quantile(far, 0.9));
}

TEST(Distribution, ATriangularOneFollowsItsSquare) {
  // Below the mode F = (x - min)^2 / ((max - min)(mode - min)).
  EXPECT_NEAR(quantile(Triangular{0, 1, 4}, 0.16), 0.8, 1e-12);
  EXPECT_NEAR(quantile(Triangular{0, 0, 4}, 0.75), 2, 1e-12);
}

TEST(Distribution, APertOneHasItsMean) {
  EXPECT_NEAR(moments(Pert{0, 1, 4}).first, (0 + 4 * 1 + 4) / 6.0, 1e-5);
}

TEST(Distribution, DiscreteValuesComeAsOftenAsTheirWeights) {
  const Discrete d{{3, 5, 9}, {0.25, 0.5, 0.25}};
  EXPECT_EQ(quantile(d, 0.2499), 3);
  EXPECT_EQ(quantile(d, 0.2501), 5);
  EXPECT_EQ(quantile(d, 0.7499), 5);
  EXPECT_EQ(quantile(d, 0.9999999), 9);
}

TEST(Distribution, EveryFaultOfItsParametersIsTold) {
  EXPECT_EQ(faults_of(Normal{1, 0, {}, {}}).at(0).pointer, "/sd");
  EXPECT_EQ(faults_of(Normal{1, 1, 2.0, 1.0}).at(0).pointer, "/max");
  EXPECT_NE(faults_of(Normal{0, 1, 6.0, {}}).at(0).message.find("1 %"), std::string::npos);
  EXPECT_EQ(faults_of(Lognormal{-1, 4}).size(), 2U);
  EXPECT_EQ(faults_of(Uniform{2, 2}).at(0).pointer, "/max");
  EXPECT_EQ(faults_of(Triangular{0, 5, 4}).at(0).pointer, "/mode");
  EXPECT_EQ(faults_of(Pert{4, 2, 1}).at(0).pointer, "/max");
  const auto weights = faults_of(Discrete{{1, 2}, {0.5, 0.6}});
  ASSERT_EQ(weights.size(), 1U);
  EXPECT_EQ(weights[0].pointer, "/weights");
  EXPECT_NE(weights[0].message.find("1.1"), std::string::npos);
  EXPECT_EQ(faults_of(Discrete{{1, 2}, {1}}).at(0).pointer, "/weights");
  EXPECT_EQ(faults_of(Discrete{{1, 2}, {1.5, -0.5}}).at(0).pointer, "/weights/1");
  EXPECT_TRUE(faults_of(Discrete{{1, 2, 3}, {0.333333, 0.333333, 0.333334}}).empty());
}

}  // namespace
}  // namespace leda::solver
