// Rate and flow laws in the inner loop against the laws themselves (solver/materials/rate/).

#include <gtest/gtest.h>

#include "solver/materials/rate.hpp"
#include "tests/solver/block.hpp"

namespace leda::solver::test {
namespace {

constexpr double peak = 20e3;

template <class Real>
class ViscousLaws : public ::testing::Test {};
TYPED_TEST_SUITE(ViscousLaws, BothPrecisions, PrecisionNames);

/// Shear stress of an element in simple shear at a rate, after the elastic part and then some.
template <class Real>
double stress_at_rate(const std::optional<RateLaw>& rate_law, const std::optional<FlowLaw>& flow,
                      double rate) {
  Section section;
  Material& m = section.materials["clay"];
  m.unit_weight = 17e3;
  m.shear_modulus_Pa = 4e6;
  m.poisson_ratio = 0.45;
  m.peak_strength.constant_Pa = peak;
  m.rate = rate_law;
  m.flow = flow;
  LawTableBuilder builder(section, 1);
  builder.row(0, 0, 0);
  Block<Real> block(1, 4, 4, 1, 1, 1, 1, {});
  block.laws = builder.table();
  Element<Real> b(block);
  // Steps far smaller than the strain in which the stress settles, over fifty times that strain;
  // short enough that the Jaumann turn does not show.
  const double factor = rate_law ? strength_factor(*rate_law, rate) : 1;
  const double stress = flow ? flow_stress(*flow, factor * peak, rate) : factor * peak;
  const double strain = 5 * stress / m.shear_modulus_Pa;
  const int steps = 2000;
  for (int i = 0; i < steps; ++i) b.strain(0, rate, 0, 0, strain / steps / rate);
  const Particle p = b.particles().front();
  return std::hypot((p.sxx - p.szz) / 2, p.sxz);
}

TYPED_TEST(ViscousLaws, StrengthAtARateIsThatOfTheLaw) {
  for (const RateLaw& law :
       {RateLaw{SemiLogarithmicRate{0.1, 1e-4}}, RateLaw{PowerRate{0.08, 1e-4}},
        RateLaw{AdditivePowerRate{0.3, 0.5, 1e-2}}}) {
    for (const double rate : {1e-6, 1e-4, 1e-2, 1.0, 30.0}) {
      const double expected = peak * strength_factor(law, rate);
      EXPECT_NEAR(stress_at_rate<TypeParam>(law, {}, rate), expected,
                  within<TypeParam>(1e-5, 1e-9) * expected)
          << law.index() << " at " << rate;
    }
  }
}

// In steady flow all strain is viscoplastic; what is left of the approach to it decays with
// exp(-G t / eta) for Bingham, hence 1 %.
TYPED_TEST(ViscousLaws, SteadyFlowHasTheStressOfTheLaw) {
  for (const FlowLaw& law :
       {FlowLaw{BinghamFlow{500}}, FlowLaw{HerschelBulkleyFlow{2000, 0.3}},
        FlowLaw{HerschelBulkleyFlow{300, 0.1}}, FlowLaw{HerschelBulkleyFlow{40, 1.8}}}) {
    for (const double rate : {1e-6, 1e-2, 1.0, 10.0}) {
      const double expected = flow_stress(law, peak, rate);
      EXPECT_NEAR(stress_at_rate<TypeParam>({}, law, rate), expected, 0.01 * expected)
          << law.index() << " at " << rate;
    }
  }
}

// Where two materials meet, the one without such a law keeps its strength at any rate.
TYPED_TEST(ViscousLaws, AMaterialWithoutThemKeepsItsStrengthBesideOneThatHasThem) {
  Section section;
  for (const char* name : {"fast", "plain"}) {
    Material& m = section.materials[name];
    m.unit_weight = 17e3;
    m.shear_modulus_Pa = 4e6;
    m.poisson_ratio = 0.45;
    m.peak_strength.constant_Pa = peak;
  }
  section.materials["fast"].rate = PowerRate{0.1, 1e-3};
  LawTableBuilder builder(section, 1);
  builder.row(0, 0, 0);
  builder.row(1, 0, 0);
  Block<TypeParam> block(1, 4, 4, 1, 1, 1, 1, {});
  block.laws = builder.table();
  block.particles[1].law = 1;
  Element<TypeParam> b(block);
  for (int i = 0; i < 400; ++i) b.strain(0, 1, 0, 0, 5e-5);
  const Particles p = b.particles();
  const auto radius = [&](std::size_t i) {
    return std::hypot((p[i].sxx - p[i].szz) / 2, p[i].sxz);
  };
  EXPECT_NEAR(radius(0), peak * std::pow(1000, 0.1), 1);
  EXPECT_NEAR(radius(1), peak, within<TypeParam>(0.2, 1e-6));
}

TEST(LawTableOfQuietStages, HasNoRateAndNoFlow) {
  Section section;
  Material& m = section.materials["clay"];
  m.unit_weight = 17e3;
  m.shear_modulus_Pa = 4e6;
  m.peak_strength.constant_Pa = peak;
  LawTableBuilder plain(section, 1);
  plain.row(0, 0, 0);
  EXPECT_TRUE(plain.table().viscous.empty());
  m.flow = BinghamFlow{10};
  LawTableBuilder flowing(section, 1);
  flowing.row(0, 0, 0);
  EXPECT_FALSE(flowing.table().viscous.empty());
  EXPECT_TRUE(without_softening(flowing.table(), false).viscous.empty());
}

}  // namespace
}  // namespace leda::solver::test
