// Areas under a softening curve: closed form, quadrature and published values.

#include "solver/element_test/dissipation.hpp"

#include <gtest/gtest.h>

#include "solver/materials/softening.hpp"
#include "tests/element/clay.hpp"

namespace leda::solver {
namespace {

std::vector<SofteningCurve> curves() {
  const std::vector<SofteningLaw> laws{
      test::sainte_monique().law, UrmiSoftening{1.526, 4.8, 1.2, 200, {}, {}},
      EinavRandolphSoftening{700, 1.2}, LinearSoftening{70, 0.5}, DeySoftening{5000, 0.3, 3, 70}};
  std::vector<SofteningCurve> result;
  for (const auto& law : laws) {
    for (const double cell : {0.014, 0.5, 2.0}) {
      result.push_back(softening_curve({law}, 16200, cell));
    }
  }
  return result;
}

TEST(Dissipation, OfTheSitesOfTable41) {
  for (const auto& row : test::table("softening_law_sites.csv")) {
    const SofteningCurve c = softening_curve(test::urmi(row), 1000 * row["peak_kPa"], 0.014);
    const double tolerance = row["tolerance_kPa"];
    EXPECT_NEAR(dissipation(c, c.line_end) / 1000, row["dissipation_kPa"], tolerance);
    EXPECT_NEAR(dissipation_by_quadrature(c, c.line_end) / 1000, row["dissipation_kPa"], tolerance);
  }
}

// Both are exact but for rounding; the quadrature is asked for 1e-13.
TEST(Dissipation, ClosedFormIsTheQuadrature) {
  for (const auto& c : curves()) {
    for (const double strain : {0.001, 0.05, 0.7, 1.9, 12.0}) {
      const double closed = dissipation(c, strain);
      EXPECT_NEAR(dissipation_by_quadrature(c, strain), closed, 1e-9 * closed) << strain;
    }
    EXPECT_NEAR(excess_by_quadrature(c), excess(c), 1e-9 * excess(c));
  }
}

TEST(Excess, OfSainteMoniqueIsTheEnergyOfTheSmearedCrack) {
  const auto row = test::table("smeared_crack_scaling.csv").front();
  const SofteningCurve c = softening_curve(test::sainte_monique(2.9), 40500, 0.014);
  // 0.168096 kN/m: 0.014 x 36.6525 x 0.95 / 2.9, where the published s_uR of eq. 4-3 is kept whole.
  EXPECT_NEAR(0.014 * excess(c) / 1000, 0.014 * 36.6525 * 0.95 / 2.9, 1e-12);
  EXPECT_NEAR(0.014 * excess(c) / 1000, row["excess_kN_m"], 1e-6);
}

TEST(Excess, ToTheResidualStrainLacksTheTail) {
  const SofteningCurve c = softening_curve(test::sainte_monique(2.9), 40500, 0.014);
  const double lacking = std::exp(-2.9 * 1.8);
  EXPECT_NEAR(excess_to_residual_strain(c) / excess(c), 1 - lacking, 1e-12);
}

TEST(SteepestLoss, IsTheSlopeAtYield) {
  const SofteningCurve c = softening_curve(test::sainte_monique(2.9), 40500, 0.5);
  const double step = 1e-9;
  EXPECT_NEAR(steepest_loss(c), (strength(c, 0) - strength(c, step)) / step,
              1e-4 * steepest_loss(c));
  const SofteningCurve line = softening_curve({LinearSoftening{500, 0.5}}, 40500, 0.014);
  EXPECT_DOUBLE_EQ(steepest_loss(line), 40000 / 0.5);
}

}  // namespace
}  // namespace leda::solver
