// Remolding index over energy to stress over strain (thesis 3.3).

#include "solver/element_test/energy_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/element_test/dissipation.hpp"
#include "solver/materials/softening.hpp"
#include "tests/element/clay.hpp"

namespace leda::solver {
namespace {

// Eqs 3-3 and 3-5 by hand; six printed decimals.
TEST(EnergyCurve, PeakStrainOfTheSitesOfTable31) {
  for (const auto& row : test::table("tavenas_sites.csv")) {
    const LabCurve curve = to_stress_strain({}, 1000 * row["peak_kPa"], 1000 * row["remolded_kPa"],
                                            1000 * row["preconsolidation_kPa"]);
    ASSERT_EQ(curve.strain.size(), 2U);
    EXPECT_NEAR(curve.strain.back(), row["peak_strain"], 1e-6) << row.text("site");
    EXPECT_DOUBLE_EQ(curve.stress_Pa.back(), 1000 * row["peak_kPa"]);
  }
}

TEST(EnergyCurve, TwoStepsByHand) {
  // s_up 40, s_ur 2 kPa, sigma'_p 100 kPa: w_LS 1.3 kPa, gamma_p 0.065.
  // I_r 0.5 at w_N 5: s 21; gamma 0.065 + 2 x 5.2/61. I_r 0.9 at w_N 15: s 5.8; + 2 x 13/26.8.
  const LabCurve c = to_stress_strain({{0.5, 0.9}, {5, 15}}, 40e3, 2e3, 100e3);
  ASSERT_EQ(c.strain.size(), 4U);
  EXPECT_NEAR(c.stress_Pa[2], 21e3, 1e-9);
  EXPECT_NEAR(c.strain[2], 0.065 + 10.4 / 61, 1e-12);
  EXPECT_NEAR(c.stress_Pa[3], 5.8e3, 1e-9);
  EXPECT_NEAR(c.strain[3], 0.065 + 10.4 / 61 + 26 / 26.8, 1e-12);
}

// A known law, turned into energy and back: the law again. Eq. 3-6 is a trapezoid, so the error
// falls with the step; steps of 1/300 of the loss leave under 0.1 % of the strain.
TEST(EnergyCurve, GivesBackTheLawItWasMadeFrom) {
  const double peak = 39e3, remolded = 1.3e3, preconsolidation = 125e3;  // Louiseville, Table 3-1
  const EinavRandolphSoftening law{remolded, 14.0};                      // gamma_95 1400 %
  const SofteningCurve curve = softening_curve({law}, peak, 0.014);
  const double limit = limit_state_energy(preconsolidation);
  EnergyCurve energy;
  std::vector<double> plastic;
  for (int i = 0; i < 405; ++i) {  // to 29.8
    const double g = 0.01 * std::pow(1.02, i);
    plastic.push_back(g);
    energy.remolding_index.push_back((peak - strength(curve, g)) / (peak - remolded));
    energy.normalized_energy.push_back(1 + dissipation(curve, g) / limit);
  }
  const LabCurve found = to_stress_strain(energy, peak, remolded, preconsolidation);
  const double peak_strain = 2 * limit / peak;
  for (std::size_t i = 0; i < plastic.size(); ++i) {
    EXPECT_NEAR(found.strain[i + 2] - peak_strain, plastic[i], 1e-3 * plastic[i] + 1e-6);
    EXPECT_NEAR(found.stress_Pa[i + 2], strength(curve, plastic[i]), 1e-6);
  }
}

}  // namespace
}  // namespace leda::solver
