// Smeared crack: equal energy in a cell, in closed form and by root finding.

#include "solver/element_test/calibrate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/element/clay.hpp"
#include "tests/verification/record.hpp"

namespace leda::solver {
namespace {

using test::table;

Calibration calibrated(double cell, Regularization regularization, double beta = 2.9) {
  Softening softening = test::sainte_monique(beta);
  softening.regularization = regularization;
  return calibrate(softening, 40500, 5e6, cell);
}

TEST(Calibrate, BetaOfTheSmearedCrackInClosedForm) {
  double off = 0;
  for (const auto& row : table("smeared_crack_scaling.csv")) {
    const Calibration c = calibrated(row["cell_m"], Regularization::beta, row["beta_reference"]);
    const double tolerance = row["tolerance_rel"];
    EXPECT_NEAR(c.cell.rate, row["beta_cell"], tolerance * row["beta_cell"]);
    off = std::max(off, std::abs(c.cell.rate / row["beta_cell"] - 1));
    EXPECT_NEAR(c.reference_excess / 1000, row["excess_kN_m"], 2e-6);
    EXPECT_NEAR(c.cell_excess, c.reference_excess, 1e-9 * c.reference_excess);
  }
  leda::test::record("largest ", off);
}

// The root finder stops at 48 bits and the quadrature at 1e-13: 1e-9 leaves room for both.
TEST(Calibrate, RootFindingAgreesWithTheClosedForm) {
  for (const auto regularization : {Regularization::beta, Regularization::whole_curve}) {
    for (const double cell : {0.014, 0.25, 0.5, 1.0, 2.0, 10.0}) {
      const Calibration c = calibrated(cell, regularization);
      ASSERT_TRUE(c.scale_numerical.has_value());
      EXPECT_NEAR(*c.scale_numerical / c.scale_closed_form, 1, 1e-9) << cell;
    }
  }
}

TEST(Calibrate, RootFindingAgreesForEveryLaw) {
  const std::vector<SofteningLaw> laws{
      UrmiSoftening{1.526, 4.8, 1.2, 200, {}, {}}, EinavRandolphSoftening{700, 1.2},
      ExponentialSoftening{700, 20}, LinearSoftening{700, 0.5}, DeySoftening{5000, 0.3, 3, 700}};
  for (const auto& law : laws) {
    for (const auto regularization : {Regularization::beta, Regularization::whole_curve}) {
      const Calibration c = calibrate({law, 0.014, regularization}, 16200, 5e6, 0.75);
      ASSERT_TRUE(c.scale_numerical.has_value()) << law.index();
      EXPECT_NEAR(*c.scale_numerical / c.scale_closed_form, 1, 1e-9) << law.index();
    }
  }
}

TEST(Calibrate, WholeCurveKeepsEveryEnergyAndBetaKeepsOnlyTheExcess) {
  const Calibration whole = calibrated(0.5, Regularization::whole_curve);
  EXPECT_NEAR(whole.cell_total, whole.reference_total, 1e-9 * whole.reference_total);
  const Calibration beta = calibrated(0.5, Regularization::beta);
  // Plateau and tail keep their strains: 36 times what they did
  // at 0.5 m, which makes the whole 24 times the energy of the specimen.
  EXPECT_NEAR(beta.cell_total / beta.reference_total, 24.3, 0.1);
}

// Counting the area to gamma_R only, as a test shows it, leaves out exp(-2.9 x 1.8) = 0.54 % of the
// specimen's energy and nothing of the cell's: beta rises by that share.
TEST(Calibrate, AreaToTheResidualStrainGivesSlightlyMore) {
  const Calibration c = calibrated(0.5, Regularization::beta);
  ASSERT_TRUE(c.scale_to_residual_strain.has_value());
  EXPECT_NEAR(*c.scale_to_residual_strain / c.scale_closed_form, 1 / (1 - std::exp(-2.9 * 1.8)),
              1e-9);
}

// The thesis against equal energy: 105 and 80 / 90 / 140 / 160 / 150. The first is an equal-energy
// value, to its rounding; the others are off by what is asserted here, so that a change shows.
TEST(Calibrate, PublishedBetaBesideEqualEnergy) {
  const std::vector<double> published_over_equal{1.014, 0.896, 0.869, 0.676, 0.515, 0.750};
  const auto rows = table("published_beta.csv");
  ASSERT_EQ(rows.size(), published_over_equal.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& row = rows[i];
    const Calibration c = calibrate(test::urmi(row, "beta_reference"), 1000 * row["peak_kPa"],
                                    1000 * row["shear_modulus_kPa"], row["cell_m"]);
    EXPECT_NEAR(row["beta_published"] / c.cell.rate, published_over_equal[i], 0.0006)
        << row.text("site") << " " << row.text("cell_m");
  }
}

TEST(Calibrate, SnapBackIsSaid) {
  EXPECT_FALSE(calibrated(0.5, Regularization::beta).snaps_back);  // 3.6 MPa against G of 5 MPa
  EXPECT_TRUE(calibrated(1.0, Regularization::beta).snaps_back);   // 7.2 MPa
}

TEST(Calibrate, WithoutRegularizationNothingIsScaled) {
  const Calibration c = calibrated(0.5, Regularization::none);
  EXPECT_DOUBLE_EQ(c.scale_closed_form, 1);
  EXPECT_FALSE(c.scale_numerical.has_value());
  EXPECT_NEAR(c.cell_total / c.reference_total, 0.5 / 0.014, 1e-9);
}

TEST(Calibrate, ClayWithNothingToLoseHasNoRoot) {
  UrmiSoftening law{1, 2.8, 1.8, 736, 40500.0, 9.0};
  const Calibration c = calibrate({law}, 40500, 5e6, 0.5);
  EXPECT_FALSE(c.scale_numerical.has_value());
}

}  // namespace
}  // namespace leda::solver
