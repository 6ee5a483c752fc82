// Predicted distributions and their scores.

#include <gtest/gtest.h>

#include <cmath>

#include "solver/hindcast/coverage.hpp"
#include "solver/hindcast/mixture.hpp"

namespace leda::solver {
namespace {

Mixture three_members() {
  Mixture m;
  m.add(2, 4.0, false);
  m.add(1, 4.8, false);
  m.add(1, 5.5, false);
  m.close(0.3);
  return m;
}

TEST(Mixture, QuantilesAreWhereItsDistributionIs) {
  const Mixture m = three_members();
  for (const double p : {0.05, 0.5, 0.95}) EXPECT_NEAR(m.cdf(m.quantile(p)), p, 1e-9);
  EXPECT_NEAR(*m.quantile_at_most(0.95), m.quantile(0.95), 1e-9);
}

TEST(Mixture, ScoreOfANormalIsTheKnownOne) {
  Mixture m;
  m.add(1, 0, false);
  m.close(1);
  EXPECT_NEAR(m.crps(0), 0.233694977, 1e-5);  // 2 / sqrt(2 pi) - 1 / sqrt(pi)
}

TEST(Mixture, ScoreIsTheIntegralOverTheSquareOfWhatIsAmiss) {
  const Mixture m = three_members();
  for (const double y : {3.5, 4.6, 7.0}) {
    double sum = 0;
    constexpr double step = 1e-3;
    for (double x = 0; x < 12; x += step) {
      const double amiss = m.cdf(x + step / 2) - (x + step / 2 >= y ? 1 : 0);
      sum += step * amiss * amiss;
    }
    EXPECT_NEAR(m.crps(y), sum, 1e-3);
  }
}

TEST(Mixture, HasNoUpperEndWhereTooManyMembersWereCutShort) {
  Mixture m;
  m.add(0.9, 4, false);
  m.add(0.1, 4, true);
  m.close(0.3);
  EXPECT_NEAR(m.beyond(), 0.1, 1e-12);
  EXPECT_FALSE(m.quantile_at_most(0.95));
  // The rest has its 0.8 / 0.9 quantile there.
  EXPECT_NEAR(*m.quantile_at_most(0.8), 4 + 0.3 * 1.220640349, 1e-6);
  EXPECT_NEAR(m.quantile(0.5), 4, 1e-9);
}

TEST(Coverage, HasTheChanceOfSoFewHitsOrFewer) {
  EXPECT_NEAR(coverage(2, 4, 0.9).chance, 0.0523, 1e-4);
  EXPECT_NEAR(coverage(4, 6, 0.9).chance, 0.1143, 1e-4);
  EXPECT_NEAR(coverage(6, 8, 0.9).chance, 0.1869, 1e-4);
  EXPECT_NEAR(coverage(8, 10, 0.9).chance, 0.2639, 1e-4);
  EXPECT_EQ(coverage(4, 4, 0.9).chance, 1);
  EXPECT_EQ(coverage(0, 0, 0.9).chance, 1);
}

}  // namespace
}  // namespace leda::solver
