// Tresca with a tension cut-off, in the very kernel of the solver.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/solver/block.hpp"
#include "tests/solver/closest_point.hpp"
#include "tests/verification/record.hpp"

namespace leda::solver::test {
namespace {

template <class Real>
class Tension : public ::testing::Test {};
TYPED_TEST_SUITE(Tension, BothPrecisions, PrecisionNames);

constexpr double shear = 1e4, tensile = 3e3;

template <class Real>
Element<Real> element(double tension = tensile, double poisson_ratio = 0.3) {
  Block<Real> block(1, 4, 4, 1, 1, 1, 1, {1e7, poisson_ratio, 1700, shear});
  block.laws.tension = {tension};
  return Element<Real>(block);
}

// Stresses on all sides of the surface, within and far beyond: faces, edges, corners and the apex,
// the principal stress across the plane in every place.
TYPED_TEST(Tension, ReturnsToTheClosestPoint) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> stress(-4 * shear, 5 * shear);
  for (const double t : {0.0, tensile, 2 * shear}) {
    Element<TypeParam> e = element<TypeParam>(t);
    const double g = e.model.laws.shear[0], lame = e.model.laws.bulk[0] - 2.0 / 3.0 * g;
    double off = 0;
    for (int i = 0; i < 2000; ++i) {
      const std::array<double, 3> trial{stress(random), stress(random), stress(random)};
      e.set_stress(trial[0], trial[1], trial[2]);
      e.strain(0, 0, 0, 0, 1);
      const Particle p = e.particles().front();
      const auto expected = sorted(closest_point(trial, {shear, t}, g, lame));
      const auto found = sorted({p.sxx, p.szz, p.syy});
      for (std::size_t k = 0; k < 3; ++k) off = std::max(off, std::abs(found[k] - expected[k]));
    }
    leda::test::record("tensile strength ", t / 1000, " kPa: off by ", 100 * off / shear,
                       " % of s");
    EXPECT_LT(off, within<TypeParam>(2e-6, 1e-9) * 5 * shear) << t;
  }
}

// Stretched in the plane, ground cracks at T and the face of the crack stays in the direction of
// the pull.
TYPED_TEST(Tension, UniaxialStretchEndsAtTheTensileStrength) {
  Element<TypeParam> e = element<TypeParam>();
  for (int i = 0; i < 200; ++i) e.strain(1e-4, 0, 0, 0, 1);
  const Particle p = e.particles().front();
  EXPECT_NEAR(p.sxx, tensile, within<TypeParam>(1e-2, 1e-6));
  EXPECT_LE(std::max(p.szz, p.syy), tensile * (1 + 1e-6));
  EXPECT_NEAR(p.sxz, 0, 1);
}

// What only opens a crack softens nothing: a pull alike in all directions is no shear.
TYPED_TEST(Tension, APullFromAllSidesLeavesNoShearStrain) {
  Element<TypeParam> e = element<TypeParam>();
  e.set_stress(5e4, 5e4, 5e4);
  e.strain(0, 0, 0, 0, 1);
  const Particle p = e.particles().front();
  for (const double s : {p.sxx, p.szz, p.syy})
    EXPECT_NEAR(s, tensile, within<TypeParam>(1e-2, 1e-6));
  EXPECT_NEAR(p.plastic_strain, 0, 1e-6);
}

// Where nothing is pulled, the surface is Tresca's.
TYPED_TEST(Tension, ChangesNothingUnderCompression) {
  Element<TypeParam> with = element<TypeParam>(0);
  Element<TypeParam> without = element<TypeParam>(beyond_reach);
  for (auto* e : {&with, &without}) {
    e->set_stress(-8e4, -9e4, -8e4);
    for (int i = 0; i < 100; ++i) e->strain(1e-4, 2e-5, 0, -1e-4, 1);
  }
  const Particle a = with.particles().front(), b = without.particles().front();
  EXPECT_DOUBLE_EQ(a.sxx, b.sxx);
  EXPECT_DOUBLE_EQ(a.szz, b.szz);
  EXPECT_DOUBLE_EQ(a.sxz, b.sxz);
  EXPECT_NEAR(a.plastic_strain, b.plastic_strain, 1e-6 * b.plastic_strain);
}

// The tensile strength falls as the shear strength does.
TYPED_TEST(Tension, FallsWithTheShearStrength) {
  Block<TypeParam> block(1, 4, 4, 1, 1, 1, 1, {1e7, 0.3, 1700, shear});
  LawTable& t = block.laws;
  t.tension = {tensile};
  t.softens = {1};
  t.line_end = {0.001};  // a tenth of the peak from there on
  t.last = {0.1 * shear};
  Element<TypeParam> e(block);
  for (auto& pack : e.model.packs.pack) {
    std::ranges::fill(pack.plastic_strain, TypeParam{1});
  }
  for (int i = 0; i < 200; ++i) e.strain(1e-4, 0, 0, 0, 1);
  EXPECT_NEAR(e.particles().front().sxx, 0.1 * tensile, 1);
}

}  // namespace
}  // namespace leda::solver::test
