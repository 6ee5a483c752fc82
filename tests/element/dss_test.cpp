// Direct simple shear by the bare law.

#include "solver/element_test/dss.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/element_test/dissipation.hpp"
#include "solver/materials/softening.hpp"
#include "tests/element/clay.hpp"

namespace leda::solver {
namespace {

using test::sainte_monique_modulus;
using test::sainte_monique_peak;

DssCurve sheared(double cell, double beta = 2.8) {
  return dss_of_bare_law({sainte_monique_modulus,
                          softening_curve(test::sainte_monique(beta), sainte_monique_peak, cell),
                          cell});
}

void expect_growing(const DssCurve& curve) {
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    ASSERT_GE(curve.points[i].strain, curve.points[i - 1].strain) << i;
    ASSERT_GE(curve.points[i].plastic_strain, curve.points[i - 1].plastic_strain) << i;
  }
}

TEST(Dss, IsElasticUpToThePeakStrainOfTable41) {
  const DssCurve curve = sheared(0.014);
  EXPECT_GT(std::count_if(curve.points.begin(), curve.points.end(),
                          [](const DssPoint& p) { return p.plastic_strain == 0; }),
            10);  // enough to draw the rise, also over a logarithm
  EXPECT_NEAR(stress_at(curve, 0.005), 0.005 * sainte_monique_modulus, 1e-6);
  double top = 0, at = 0;
  for (const auto& p : curve.points) {
    if (p.stress_Pa > top) top = p.stress_Pa, at = p.strain;
  }
  EXPECT_DOUBLE_EQ(top, 40500);
  EXPECT_NEAR(at, 0.01, 1e-12);  // gamma_p = s_up / G
}

// Every point must lie on the law; 2 % of s_up is what a solver is allowed, the bare law has none.
TEST(Dss, FollowsEquation42AlongTheWholeCurve) {
  const SofteningCurve law = softening_curve(test::sainte_monique(), 40500, 0.014);
  const DssCurve curve = sheared(0.014);
  expect_growing(curve);
  EXPECT_FALSE(curve.snaps_back);
  std::size_t softened = 0;
  double last_plastic = 0;
  for (const auto& p : curve.points) {
    EXPECT_NEAR(p.strain, p.plastic_strain + p.stress_Pa / sainte_monique_modulus, 1e-4);
    if (p.plastic_strain <= 0.01) continue;
    // A drop at a held strain (gamma_R) is drawn by a point between its two sides.
    const double before = strength(law, last_plastic);
    EXPECT_LE(p.stress_Pa, before + 1e-6);
    EXPECT_NEAR(p.stress_Pa, strength(law, p.plastic_strain), 0.006 * 40500) << p.plastic_strain;
    last_plastic = p.plastic_strain;
    ++softened;
  }
  EXPECT_GT(softened, 200U);
  EXPECT_NEAR(curve.points.back().stress_Pa, 736, 1e-6);
}

TEST(Dss, InterpolatedStressIsTheLawWithinAThousandthOfThePeak) {
  const SofteningCurve law = softening_curve(test::sainte_monique(), 40500, 0.014);
  const DssCurve curve = sheared(0.014);
  for (int i = 0; i < 91; ++i) {  // to 8.8
    const double plastic = 0.02 * std::pow(1.07, i);
    if (std::abs(plastic - 1.8) < 0.01) continue;
    const double stress = strength(law, plastic);
    EXPECT_NEAR(stress_at(curve, plastic + stress / sainte_monique_modulus), stress, 40.5);
  }
}

TEST(Dss, WorkIsElasticPlusDissipated) {
  const SofteningCurve law = softening_curve(test::sainte_monique(), 40500, 0.014);
  const DssCurve curve = sheared(0.014);
  const double end = curve.points.back().plastic_strain;
  const double left = std::pow(736, 2) / 2 / sainte_monique_modulus;
  // Sudden drops (at yield, alpha < 1, and at gamma_R) dissipate what the law's area leaves out.
  const double drop =
      (40500 * 40500 - strength(law, 0) * strength(law, 0)) / 2 / sainte_monique_modulus;
  const double expected = 0.014 * (dissipation(law, end) + left + drop);
  EXPECT_NEAR(work_per_area(curve), expected, 0.002 * expected);
}

TEST(Dss, SnapsBackWhereTheLawLosesFasterThanTheShearModulus) {
  // alpha beta (s_up - s_uR) = 34.8 kPa x beta exceeds G = 4050 kPa from beta = 116 on.
  EXPECT_FALSE(sheared(0.5, 2.9).snaps_back);  // beta 103.6
  const DssCurve curve = sheared(1.0, 2.9);    // beta 207
  EXPECT_TRUE(curve.snaps_back);
  expect_growing(curve);
  double drop = 0;
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    if (curve.points[i].strain == curve.points[i - 1].strain) {
      drop = std::max(drop, curve.points[i - 1].stress_Pa - curve.points[i].stress_Pa);
    }
  }
  EXPECT_GT(drop, 10000);
}

TEST(Dss, StopsAtTheStrainAskedFor) {
  const SofteningCurve law = softening_curve(test::sainte_monique(), 40500, 0.014);
  for (const double end : {0.004, 0.01, 0.3, 1.85, 5.0, 50.0}) {
    const DssCurve curve = dss_of_bare_law({sainte_monique_modulus, law, 0.014}, end);
    EXPECT_NEAR(curve.points.back().strain, end, 1e-12 + 1e-9 * end);
    expect_growing(curve);
  }
}

TEST(Dss, ClayThatDoesNotSoftenKeepsItsPeak) {
  const DssCurve curve = dss_of_bare_law({1e7, perfectly_plastic(90000), 0.5});
  expect_growing(curve);
  EXPECT_DOUBLE_EQ(stress_at(curve, 0.02), 90000);
  EXPECT_DOUBLE_EQ(curve.points.back().stress_Pa, 90000);
}

TEST(Dss, LawsWithoutEndAndStraightLawsAreSheared) {
  for (const SofteningLaw& law :
       {SofteningLaw{EinavRandolphSoftening{700, 1.2}}, SofteningLaw{LinearSoftening{700, 1.2}},
        SofteningLaw{DeySoftening{5000, 0.3, 3, 700}}}) {
    const SofteningCurve c = softening_curve({law}, 40500, 0.014);
    const DssCurve curve = dss_of_bare_law({4.05e6, c, 0.014});
    expect_growing(curve);
    EXPECT_NEAR(curve.points.back().stress_Pa, 700, 10);
    const double stress = strength(c, 0.5);
    EXPECT_NEAR(stress_at(curve, 0.5 + stress / 4.05e6), stress, 40);
  }
}

}  // namespace
}  // namespace leda::solver
