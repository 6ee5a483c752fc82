// Direct simple shear by the solver's particles against the bare law (eq. 4-2).

#include "solver/element_test/dss_of_particles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/materials/softening.hpp"
#include "tests/element/clay.hpp"

namespace leda::solver {
namespace {

Material clay_of(const test::Row& row, const std::string& beta) {
  Material m;
  m.unit_weight = 16000;
  m.shear_modulus_Pa = 1000 * row["shear_modulus_kPa"];
  m.poisson_ratio = 0.45;
  m.peak_strength.constant_Pa = 1000 * row["peak_kPa"];
  m.softening = test::urmi(row, beta);
  return m;
}

/// Largest distance of a curve from the bare law in stress, share of the peak. Steps of the solver
/// smear a sudden drop over a strain of about 3e-4: there the law's stresses within that reach.
double distance(const DssCurve& curve, const DssCurve& law, double peak) {
  constexpr double reach = 3e-4;
  double worst = 0;
  for (const auto& p : curve.points) {
    double least = std::min(stress_at(law, p.strain - reach), stress_at(law, p.strain + reach));
    double most = std::max(stress_at(law, p.strain - reach), stress_at(law, p.strain + reach));
    for (const auto& q : law.points) {
      if (std::abs(q.strain - p.strain) > reach) continue;
      least = std::min(least, q.stress_Pa);
      most = std::max(most, q.stress_Pa);
    }
    worst = std::max({worst, p.stress_Pa - most, least - p.stress_Pa});
  }
  return worst / peak;
}

DssCurve bare(const Material& m, double peak, double cell) {
  return dss_of_bare_law({m.shear_modulus_Pa, softening_curve(*m.softening, peak, cell), cell});
}

// The specimens of thesis Tables 4-1, 5-1 and 5-2 and the field cells of Tables 4-5, 5-1, 5-3,
// along the whole curve. 2 % of s_up is the accuracy asked for; 1 % is what is met.
TEST(DssOfParticles, FollowsTheLawAtEverySiteInSpecimenAndCell) {
  for (const auto& row : test::table("published_beta.csv")) {
    const Material m = clay_of(row, "beta_reference");
    const double peak = 1000 * row["peak_kPa"];
    for (const double cell : {0.014, row["cell_m"]}) {
      const DssCurve curve = dss_of_particles(m, peak, {cell, 4, 0, {}});
      const double off = distance(curve, bare(m, peak, cell), peak);
      EXPECT_LT(off, 0.01) << row.text("site") << " at " << cell << " m";
      EXPECT_GT(curve.points.size(), 100U);
      RecordProperty(row.text("site") + "_" + std::to_string(cell), std::to_string(off));
    }
  }
}

TEST(DssOfParticles, AgreesForAnyNumberOfParticles) {
  const auto row = test::table("published_beta.csv").front();
  const Material m = clay_of(row, "beta_reference");
  const DssCurve one = dss_of_particles(m, 40500, {0.5, 1, 0, 0.2});
  const DssCurve many = dss_of_particles(m, 40500, {0.5, 16, 0, 0.2});
  ASSERT_EQ(one.points.size(), many.points.size());
  for (std::size_t i = 0; i < one.points.size(); ++i) {
    EXPECT_NEAR(one.points[i].stress_Pa, many.points[i].stress_Pa, 1e-6 * 40500);
  }
}

// Consolidated under 93 kPa with K0 = 0.5 (Table 4-1) the circle of stress has a radius of 23.25
// kPa before shear: it yields at sqrt(40.5^2 - 23.25^2) = 33.2 kPa, and turns towards pure shear
// while it softens. The curve joins the law within 5 % strain.
TEST(DssOfParticles, AnisotropicConsolidationYieldsEarlierAndJoinsTheLaw) {
  const auto row = test::table("published_beta.csv").front();
  Material m = clay_of(row, "beta_reference");
  m.shear_modulus_Pa = 4.05e6;
  m.k0 = 0.5;
  const DssCurve curve = dss_of_particles(m, 40500, {0.014, 4, 93000, 0.4});
  const double yield = std::sqrt(40.5 * 40.5 - 23.25 * 23.25);
  double first_yield = 0;
  for (const auto& p : curve.points) {
    if (p.plastic_strain > 0) break;
    first_yield = p.stress_Pa / 1000;
  }
  EXPECT_NEAR(first_yield, yield, 0.6);  // the next point that is kept lies within a step of it
  const DssCurve law = bare(m, 40500, 0.014);
  for (const auto& p : curve.points) {
    EXPECT_LT(p.stress_Pa, 40500);
    if (p.strain < 0.05) continue;
    EXPECT_NEAR(p.stress_Pa, stress_at(law, p.strain), 0.02 * 40500) << p.strain;
  }
}

// Thesis eqs 2-5, 2-6, 2-8 (strength) and 2-7, 2-18 (flow) at a rate 1000 times the reference. The
// bare law leaves the elastic share out of the rate, hence 2 % of the peak.
TEST(DssOfParticles, FollowsRateAndFlowLaws) {
  Material m = clay_of(test::table("published_beta.csv").front(), "beta_reference");
  const double peak = 40500, rate = 0.014;
  const auto check = [&](const char* name) {
    const SofteningCurve law = at_rate(softening_curve(*m.softening, peak, 0.014), m, rate);
    const DssCurve bare_law = dss_of_bare_law({m.shear_modulus_Pa, law, 0.014});
    const DssCurve curve = dss_of_particles(m, peak, {0.014, 4, 0, {}, rate});
    EXPECT_GT(law.peak, 1.02 * peak) << name;
    EXPECT_LT(distance(curve, bare_law, peak), 0.02) << name;
  };
  m.rate = SemiLogarithmicRate{0.1, 1.4e-5};
  check("semi-logarithmic");
  m.rate = PowerRate{0.05, 1.4e-5};
  check("power");
  m.rate = AdditivePowerRate{0.1, 0.3, 1.4e-3};
  check("additive power");
  m.rate.reset();
  m.flow = BinghamFlow{2e5};
  check("Bingham");
  m.flow = HerschelBulkleyFlow{2e4, 0.4};
  check("Herschel-Bulkley");
}

TEST(DssOfParticles, ClayThatDoesNotSoftenKeepsItsPeak) {
  Material m = clay_of(test::table("published_beta.csv").front(), "beta_reference");
  m.softening.reset();
  const DssCurve curve = dss_of_particles(m, 40500, {0.5, 4, 0, 0.3});
  EXPECT_NEAR(curve.points.back().stress_Pa, 40500, 0.001 * 40500);
  EXPECT_DOUBLE_EQ(curve.points.back().strain, 0.3);
}

}  // namespace
}  // namespace leda::solver
