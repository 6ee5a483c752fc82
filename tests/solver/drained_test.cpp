// Ground that drains: Mohr and Coulomb with a tension cut-off, in the very kernel of the solver.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/solver/block.hpp"
#include "tests/solver/closest_point.hpp"
#include "tests/verification/record.hpp"

namespace leda::solver::test {
namespace {

template <class Real>
class Drained : public ::testing::Test {};
TYPED_TEST_SUITE(Drained, BothPrecisions, PrecisionNames);

constexpr double scale = 1e5;  // of the stresses, Pa

struct Sand {
  double cohesion_Pa, friction_deg, pore_Pa, tension_Pa;

  double angle() const { return friction_deg * std::numbers::pi / 180; }
  /// Never zero, as in the law table: shares of it are taken.
  double c_cos() const { return std::max(1e-3, cohesion_Pa * std::cos(angle())); }
};

template <class Real>
Element<Real> element(const Sand& sand, double poisson_ratio = 0.3) {
  Block<Real> block(1, 4, 4, 1, 1, 1, 1, {1e7, poisson_ratio, 1700, sand.c_cos()});
  block.laws.tension = {sand.tension_Pa};
  block.laws.sin_friction = {std::sin(sand.angle())};
  block.laws.pore_pressure = {sand.pore_Pa};
  return Element<Real>(block);
}

// Stresses on all sides of the surface: faces, both edges, the apex, the cut-off and where it meets
// them, the principal stress across the plane in every place.
TYPED_TEST(Drained, ReturnsWhereTheActiveSetSays) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> stress(-scale, 0.6 * scale);
  const Sand sands[] = {{1e4, 35, 0, 0}, {1e4, 35, 0, 8e3}, {1e4, 20, 2e4, 1e4}, {1e3, 30, 1e4, 0}};
  for (const Sand& sand : sands) {
    auto e = element<TypeParam>(sand);
    const double g = e.model.laws.shear[0], lame = e.model.laws.bulk[0] - 2.0 / 3.0 * g;
    const YieldBody body{sand.c_cos(), sand.tension_Pa - sand.pore_Pa, std::sin(sand.angle()),
                         sand.pore_Pa};
    double off = 0;
    for (int i = 0; i < 4000; ++i) {
      const std::array<double, 3> trial{stress(random), stress(random), stress(random)};
      e.set_stress(trial[0], trial[1], trial[2]);
      e.strain(0, 0, 0, 0, 1);
      const Particle p = e.particles().front();
      const auto expected = sorted(closest_point(trial, body, g, lame));
      const auto found = sorted({p.sxx, p.szz, p.syy});
      for (std::size_t k = 0; k < 3; ++k) off = std::max(off, std::abs(found[k] - expected[k]));
    }
    leda::test::record("phi' ", sand.friction_deg, " degrees, u ", sand.pore_Pa / 1000,
                       " kPa: off by ", off, " Pa of ", scale);
    EXPECT_LT(off, within<TypeParam>(2e-6, 1e-9) * scale) << sand.friction_deg;
  }
}

// A drained biaxial test: the ratio of the effective stresses at failure is (1 + sin) / (1 - sin),
// at a constant cell pressure and whatever the pore pressure (Mohr and Coulomb).
TYPED_TEST(Drained, BiaxialTestFailsAtThePrincipalStressRatio) {
  for (const double pore : {0.0, 2e4}) {
    const Sand sand{0, 35, pore, 0};
    auto e = element<TypeParam>(sand);
    e.set_stress(-5e4, -5e4, -5e4);
    double sxx = -5e4;
    for (int i = 0; i < 4000; ++i) {  // pressed upright; sideways so that the cell pressure stays
      const double sideways = (-5e4 - sxx) / 5e7;
      e.strain(sideways, 0, 0, -1e-5, 1);
      sxx = e.particles().front().sxx;
    }
    const Particle p = e.particles().front();
    const double ratio = (p.szz + pore) / (p.sxx + pore), sin = std::sin(sand.angle());
    leda::test::record("u ", pore / 1000, " kPa: ratio ", ratio);
    EXPECT_NEAR(ratio, (1 + sin) / (1 - sin), 1e-3 * ratio);
  }
}

// Without dilation shear changes no volume: under undrained shear the mean stress stays.
TYPED_TEST(Drained, ShearLeavesTheMeanStress) {
  auto e = element<TypeParam>({0, 30, 0, 0});
  e.set_stress(-8e4, -1e5, -9e4);
  for (int i = 0; i < 300; ++i) e.strain(1e-4, 0, 0, -1e-4, 1);
  const Particle p = e.particles().front();
  EXPECT_NEAR((p.sxx + p.szz + p.syy) / 3, -9e4, 1);
  EXPECT_GT(p.plastic_strain, 0.02);
}

// Dry sand is pulled apart without resistance.
TYPED_TEST(Drained, SandHoldsNoTension) {
  auto e = element<TypeParam>({0, 35, 0, 0});
  e.set_stress(-1e3, -1e3, -1e3);
  for (int i = 0; i < 50; ++i) e.strain(1e-4, 0, 0, 1e-4, 1);
  const Particle p = e.particles().front();
  for (const double s : {p.sxx, p.szz, p.syy}) EXPECT_NEAR(s, 0, 0.01);
}

}  // namespace
}  // namespace leda::solver::test
