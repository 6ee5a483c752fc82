// gamma_95 by the method of the thesis's first appendix.

#include "solver/element_test/fit_strain_95.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/materials/softening.hpp"
#include "tests/element/clay.hpp"

namespace leda::solver {
namespace {

// Table 2 prints whole percents of strain computed with the ratio (1 - 1/S_t)/2: +- 0.01.
TEST(Strain95, Equation8GivesTable2WithTheRatioItWasComputedWith) {
  for (const auto& row : test::table("appendix_strain_95.csv")) {
    EXPECT_NEAR(strain_95(row["strain_50"], row["ratio_minus"], row["sensitivity"]),
                row["strain_95"], 0.011)
        << row.text("site");
  }
}

TEST(Strain95, TheTrueHalfWayPointGivesThreeOverLogTwo) {
  for (const auto& row : test::table("appendix_strain_95.csv")) {
    const double ratio = (1 + 1 / row["sensitivity"]) / 2;
    const double found = strain_95(row["strain_50"], ratio, row["sensitivity"]);
    EXPECT_NEAR(found, 3 * row["strain_50"] / std::log(2.0), 1e-9);
    EXPECT_NEAR(found, row["strain_95_true"], 1e-3);
    EXPECT_GT(found, row["strain_95"]);
  }
}

PostPeak einav_randolph(double strain_of_95, double last_strain) {
  const double peak = 40.5e3;
  const SofteningCurve c =
      softening_curve({EinavRandolphSoftening{peak / 55, strain_of_95}}, peak, 0.014);
  PostPeak curve{peak, 0, 0, {}, {}};
  for (int i = 1; i <= 400; ++i) {
    curve.strain.push_back(last_strain * i / 400);
    curve.stress_Pa.push_back(strength(c, curve.strain.back()));
  }
  return curve;
}

// Sainte-Monique, S_t = 55, gamma_95 = 113 %, gamma_r = 340 % (the appendix rounds 339).
TEST(Strain95, GivesBackALawAndThreeTimesItsStrain) {
  const Strain95Fit fit = fit_strain_95(einav_randolph(1.13, 0.4), 40.5e3 / 55);
  ASSERT_TRUE(fit.faults.empty());
  EXPECT_NEAR(fit.reduction_used, 0.5, 1e-9);
  EXPECT_NEAR(fit.law.strain_95, 1.13, 1e-4);  // the crossing is interpolated between two points
  EXPECT_NEAR(fit.remolded_strain, 3.39, 3e-4);
  EXPECT_NEAR(fit.goodness.r2, 1, 1e-6);
  EXPECT_TRUE(fit.warnings.empty());
}

// The appendix finds 113 % for Sainte-Monique and 148 % for Saint-Jude on the laboratory's curves.
// From the laws of Table 3-4 that stand for the same tests: 113 and 144 %, so 5 % for the
// difference.
TEST(Strain95, OfTheAppendixSitesFromTheirLaws) {
  for (const auto& row : test::table("urmi_sites.csv")) {
    const double published = row.text("site") == "Sainte-Monique" ? 1.13
                             : row.text("site") == "Saint-Jude"   ? 1.48
                                                                  : 0;
    if (published == 0) continue;
    const double peak = 1000 * row["peak_kPa"];
    const SofteningCurve law = softening_curve(test::urmi(row), peak, 0.014);
    PostPeak curve{peak, 0, 0, {}, {}};
    for (int i = 1; i <= 400; ++i) {
      curve.strain.push_back(0.4 * i / 400);
      curve.stress_Pa.push_back(strength(law, curve.strain.back()));
    }
    const Strain95Fit fit = fit_strain_95(curve, 1000 * row["remolded_kPa"]);
    EXPECT_NEAR(fit.law.strain_95, published, 0.05 * published) << row.text("site");
  }
}

TEST(Strain95, UsesTheLastPointWhereTheTestEndsEarlier) {
  const Strain95Fit fit = fit_strain_95(einav_randolph(1.48, 0.2), 40.5e3 / 55);
  EXPECT_NEAR(fit.strain_used, 0.2, 1e-12);
  EXPECT_LT(fit.reduction_used, 0.5);
  EXPECT_NEAR(fit.law.strain_95, 1.48, 1e-9);
  EXPECT_EQ(fit.warnings.size(), 1U);
}

TEST(Strain95, RefusesACurveThatDoesNotFall) {
  EXPECT_FALSE(fit_strain_95({20e3, 0.01, 2e6, {0.1, 0.2}, {20e3, 20e3}}, 1e3).faults.empty());
  EXPECT_FALSE(fit_strain_95({20e3, 0.01, 2e6, {}, {}}, 1e3).faults.empty());
  EXPECT_FALSE(fit_strain_95({20e3, 0.01, 2e6, {0.1}, {10e3}}, 30e3).faults.empty());
}

}  // namespace
}  // namespace leda::solver
