// The law of Urmi et al. fitted to curves whose parameters are known.

#include "solver/element_test/fit_urmi.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "solver/element_test/dss.hpp"
#include "solver/materials/softening.hpp"
#include "tests/element/clay.hpp"

namespace leda::solver {
namespace {

/// A direct simple shear test on the clay of a row, up to a strain.
LabCurve tested(const test::Row& row, double max_strain) {
  const double peak = 1000 * row["peak_kPa"];
  const double modulus = peak / row["peak_strain"];
  const DssCurve curve =
      dss_of_bare_law({modulus, softening_curve(test::urmi(row), peak, 0.014), 0.014}, max_strain);
  LabCurve lab;
  for (const auto& p : curve.points) {
    lab.strain.push_back(p.strain);
    lab.stress_Pa.push_back(p.stress_Pa);
  }
  return lab;
}

UrmiFit fitted(const LabCurve& curve, double remolded_kPa,
               StrainMeasure measure = StrainMeasure::plastic) {
  return fit_urmi({behind_peak(curve, measure), 1000 * remolded_kPa, {}, false});
}

// 40 % strain is what a direct simple shear test reaches (thesis 3.1). The data are exact, so the
// parameters come back to the accuracy of the sampling (a drop at yield is interpolated).
TEST(FitUrmi, GivesBackTheSitesOfTable34FromFortyPercentStrain) {
  for (const auto& row : test::table("urmi_sites.csv")) {
    const UrmiFit fit = fitted(tested(row, 0.4), row["remolded_kPa"]);
    ASSERT_TRUE(fit.faults.empty()) << fit.faults.front();
    EXPECT_NEAR(fit.law.alpha, row["alpha"], 0.002 * row["alpha"]) << row.text("site");
    EXPECT_NEAR(fit.law.beta, row["beta"], 0.004 * row["beta"]) << row.text("site");
    EXPECT_NEAR(*fit.law.residual_strength_Pa / 1000, row["residual_kPa"], 0.0055);
    EXPECT_GT(fit.goodness.r2, 0.999);
  }
}

// gamma_R cannot be reproduced: the thesis reads it by eye. The stated share gives it within 13 %
// at all seven sites, and gamma_r = 0.13 s_up gamma_R with it.
TEST(FitUrmi, ResidualStrainIsReadWhereTheThesisReadsIt) {
  for (const auto& row : test::table("urmi_sites.csv")) {
    const UrmiFit fit = fitted(tested(row, 0.4), row["remolded_kPa"]);
    EXPECT_NEAR(fit.law.residual_strain, row["residual_strain"], 0.13 * row["residual_strain"])
        << row.text("site");
    EXPECT_NEAR(*fit.law.remolded_strain, 0.13 * row["peak_kPa"] * fit.law.residual_strain, 1e-9);
    EXPECT_FALSE(fit.residual_strain_from_test);
    EXPECT_FALSE(fit.remolded_strain_from_test);
  }
}

TEST(FitUrmi, WholeCurvesGiveResidualAndRemoldedStrainToo) {
  for (const auto& row : test::table("urmi_sites.csv")) {
    // Half way down the line, as the tests of Tavenas et al. go.
    const double end = (row["residual_strain"] + row["remolded_strain"]) / 2;
    const UrmiFit fit = fitted(tested(row, end), row["remolded_kPa"]);
    ASSERT_TRUE(fit.faults.empty()) << fit.faults.front();
    EXPECT_TRUE(fit.residual_strain_from_test);
    EXPECT_TRUE(fit.remolded_strain_from_test);
    EXPECT_NEAR(fit.law.residual_strain, row["residual_strain"], 0.02 * row["residual_strain"])
        << row.text("site");
    // The table's gamma_r is rounded to 1 %; the reading of gamma_R moves the line a little.
    EXPECT_NEAR(*fit.law.remolded_strain, row["remolded_strain"], 0.02 * row["remolded_strain"])
        << row.text("site");
    EXPECT_NEAR(fit.law.beta, row["beta"], 0.01 * row["beta"]);
  }
}

// Table 3-2: laws with a residual strength of their own, found as the third unknown.
TEST(FitUrmi, FindsTheResidualStrengthOfTable32) {
  for (const auto& row : test::table("urmi_tavenas.csv")) {
    const SofteningLaw law = UrmiSoftening{row["alpha"],
                                           row["beta"],
                                           row["residual_strain"],
                                           1000 * row["remolded_kPa"],
                                           1000 * row["residual_kPa"],
                                           row["remolded_strain"]};
    const double peak = 1000 * row["peak_kPa"];
    const SofteningCurve curve = softening_curve({law}, peak, 0.014);
    PostPeak points{peak, 0, 0, {}, {}};
    for (int i = 1; i <= 60; ++i) {
      points.strain.push_back(row["residual_strain"] * i / 60);
      points.stress_Pa.push_back(strength(curve, points.strain.back()));
    }
    const UrmiFit fit = fit_urmi({points, 1000 * row["remolded_kPa"], {}, true});
    ASSERT_TRUE(fit.faults.empty()) << row.text("site") << ": " << fit.faults.front();
    EXPECT_NEAR(fit.law.alpha, row["alpha"], 1e-3 * row["alpha"]) << row.text("site");
    EXPECT_NEAR(fit.law.beta, row["beta"], 1e-3 * row["beta"]) << row.text("site");
    EXPECT_NEAR(*fit.law.residual_strength_Pa, 1000 * row["residual_kPa"], 10) << row.text("site");
  }
}

// The thesis fits over total strain: alpha then carries part of exp(beta gamma_p), and as the
// elastic strain shrinks with the stress, beta rises a little.
TEST(FitUrmi, TotalStrainMovesAlphaByThePeakStrain) {
  const auto row = test::table("urmi_sites.csv").at(4);  // Sainte-Monique
  const LabCurve lab = tested(row, 0.4);
  const UrmiFit plastic = fitted(lab, row["remolded_kPa"]);
  const UrmiFit total = fitted(lab, row["remolded_kPa"], StrainMeasure::total);
  EXPECT_GT(total.law.alpha / plastic.law.alpha, 1.02);
  EXPECT_LT(total.law.alpha / plastic.law.alpha, std::exp(row["beta"] * row["peak_strain"]));
  EXPECT_NEAR(total.law.beta, plastic.law.beta, 0.05 * plastic.law.beta);
}

// Noise of 1 % of the peak on 390 points: the truth lies within four standard errors.
TEST(FitUrmi, StandardErrorsCoverNoise) {
  const auto row = test::table("urmi_sites.csv").at(2);  // Saint-Jude
  PostPeak curve = behind_peak(tested(row, 0.8), StrainMeasure::plastic);
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.01 * curve.peak_Pa);
  for (double& s : curve.stress_Pa) s += noise(random);
  const UrmiFit fit = fit_urmi({curve, 1000 * row["remolded_kPa"], {}, false});
  ASSERT_TRUE(fit.faults.empty());
  EXPECT_GT(fit.beta_error, 0);
  EXPECT_LT(fit.beta_error, 0.05 * row["beta"]);
  EXPECT_NEAR(fit.law.beta, row["beta"], 4 * fit.beta_error);
  EXPECT_NEAR(fit.law.alpha, row["alpha"], 4 * fit.alpha_error + 0.002);
  EXPECT_NEAR(fit.goodness.rmse_Pa, 0.01 * curve.peak_Pa, 0.002 * curve.peak_Pa);
  EXPECT_NEAR(fit.beta_trend_line, row["beta"], 0.1 * row["beta"]);
}

TEST(FitUrmi, WarnsWhereTheCurveEndsTooEarly) {
  const auto row = test::table("urmi_sites.csv").at(4);
  const auto mentions = [](const UrmiFit& fit) {
    return std::any_of(fit.warnings.begin(), fit.warnings.end(), [](const std::string& w) {
      return w.find("below 30 %") != std::string::npos;
    });
  };
  const UrmiFit early = fitted(tested(row, 0.1), row["remolded_kPa"]);
  EXPECT_LT(early.reduction, 0.30);
  EXPECT_TRUE(mentions(early));
  const UrmiFit late = fitted(tested(row, 0.4), row["remolded_kPa"]);
  EXPECT_GT(late.reduction, 0.30);
  EXPECT_FALSE(mentions(late));
}

TEST(FitUrmi, RefusesWhatCannotBeFitted) {
  const LabCurve rising{{0, 0.01, 0.02}, {0, 10e3, 20e3}};
  EXPECT_FALSE(fitted(rising, 1).faults.empty());
  const LabCurve flat{{0, .01, .02, .03, .04, .05}, {0, 20e3, 20e3, 20e3, 20e3, 20e3}};
  EXPECT_FALSE(fitted(flat, 1).faults.empty());
  const LabCurve falling{{0, .01, .1, .2, .3, .4}, {0, 20e3, 16e3, 13e3, 11e3, 9e3}};
  EXPECT_TRUE(fitted(falling, 1).faults.empty());
  EXPECT_FALSE(fitted(falling, 25).faults.empty());  // remolded above the peak
  EXPECT_FALSE(fitted(falling, 0).faults.empty());
  UrmiFitInput residual{behind_peak(falling, StrainMeasure::plastic), 1000, 500.0, false};
  EXPECT_FALSE(fit_urmi(residual).faults.empty());  // residual below remolded
}

}  // namespace
}  // namespace leda::solver
