#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "solver/materials/softening.hpp"
#include "tests/solver/block.hpp"
#include "tests/verification/record.hpp"

namespace leda::solver::test {
namespace {

template <class Real>
class Tresca : public ::testing::Test {};
TYPED_TEST_SUITE(Tresca, BothPrecisions, PrecisionNames);

template <class Real>
Element<Real> element(const BlockMaterial& m) {
  return Element<Real>(Block<Real>(1, 4, 4, 1, 1, 1, 1, m));
}

// The first particle of an element.
template <class Real>
Particle first(const Element<Real>& e) {
  return e.particles().front();
}

std::array<double, 3> principal(const Particle& p) {
  const double c = (p.sxx + p.szz) / 2;
  const double r = std::hypot((p.sxx - p.szz) / 2, p.sxz);
  std::array<double, 3> s{c + r, c - r, p.syy};
  std::sort(s.begin(), s.end());
  return s;
}

// validation case simple_shear_jaumann (Dienes 1979): sxz = G sin(gamma), sxx = G (1 - cos(gamma)).
TYPED_TEST(Tresca, ElasticSimpleShearIsThatOfTheJaumannRate) {
  const double g = 1e6;
  Element b = element<TypeParam>({2.6e6, 0.3, 1000, 1e30});
  const int steps = 4000;
  double off = 0;
  for (int i = 0; i < 4 * steps; ++i) {
    b.strain(0, 1, 0, 0, 0.5 / steps);
    const double gamma = 0.5 * (i + 1) / steps;
    if ((i + 1) % steps != 0) continue;
    EXPECT_NEAR(first(b).sxz, g * std::sin(gamma), 1e-3 * g);
    EXPECT_NEAR(first(b).sxx, g * (1 - std::cos(gamma)), 1e-3 * g);
    EXPECT_NEAR(first(b).szz, -first(b).sxx, 1e-6 * g);
    off = std::max({off, std::abs(first(b).sxz / g - std::sin(gamma)),
                    std::abs(first(b).sxx / g - 1 + std::cos(gamma))});
  }
  leda::test::record("largest ", 100 * off, " % of G");
}

// validation case von_mises_vs_tresca_plane_strain: flow without volume change at radius s_u,
// out-of-plane stress in the middle of the in-plane ones.
TYPED_TEST(Tresca, PlaneFlowHasTheUndrainedStrength) {
  Element b = element<TypeParam>({1e7, 0.45, 1700, 40500});
  for (int i = 0; i < 1000; ++i) b.strain(1e-4, 0, 0, -1e-4, 1);
  const auto s = principal(first(b));
  EXPECT_NEAR(s[2] - s[0], 2 * 40500.0, 1);
  EXPECT_NEAR(s[1], 0.5 * (s[0] + s[2]), 1);
  leda::test::record("strength off by ", 100 * std::abs((s[2] - s[0]) / 81000.0 - 1),
                     " %, middle stress by ", 100 * std::abs(s[1] - 0.5 * (s[0] + s[2])) / 40500,
                     " % of s_u");
}

// Closed form: after first yield at gamma_y = s_u / G, all further shear is plastic.
TYPED_TEST(Tresca, PlasticStrainIsTheShearBeyondYield) {
  const double g = 1e7 / 2.9, s = 40500;
  Element b = element<TypeParam>({1e7, 0.45, 1700, s});
  const double total = 0.1;
  for (int i = 0; i < 1000; ++i) b.strain(total / 2000, 0, 0, -total / 2000, 1);
  EXPECT_NEAR(first(b).plastic_strain, total - s / g, 1e-4 * total);
}

// The edges of the 3D surface: extension out of plane brings two principal stresses together;
// the mean stress is that of elasticity, and the surface is never left.
TYPED_TEST(Tresca, CornersAreReachedAndKeepTheMean) {
  for (const double sign : {1.0, -1.0}) {
    Element b = element<TypeParam>({1e7, 0.3, 1700, 1e4});
    for (auto& pack : b.model.packs.pack) {
      std::ranges::fill(pack.syy, static_cast<TypeParam>(sign * 5e4));
    }
    const double bulk = b.model.laws.bulk[0];
    double mean = sign * 5e4 / 3;
    b.strain(0, 0, 0, 0, 1);
    for (int i = 0; i < 50; ++i) {
      b.strain(sign * -1e-4, 1e-5, 0, sign * -1e-4, 1);
      mean -= sign * bulk * 2e-4;
      const auto s = principal(first(b));
      EXPECT_LE(s[2] - s[0], 2e4 * (1 + within<TypeParam>(1e-6, 1e-9)));
      EXPECT_NEAR((s[0] + s[1] + s[2]) / 3, mean, within<TypeParam>(1e-5, 1e-6) * 5e4);
    }
    const auto s = principal(first(b));
    EXPECT_GT(s[2] - s[0], 2e4 * (1 - 1e-6));
  }
}

// Eq. 4-2 along the whole curve, by an element in the very kernel of the solver: the law's value
// at the plastic strain of the step's start, within one step's softening (0.1 % of s_up).
TYPED_TEST(Tresca, SofteningElementFollowsEquation42) {
  UrmiSoftening law;
  law.alpha = 0.95;
  law.beta = 2.8;
  law.residual_strain = 1.8;
  law.remolded_strength_Pa = 736;
  Softening softening{law, 0.014, Regularization::none};
  const double peak = 40500;
  const SofteningCurve curve = softening_curve(softening, peak, 1.0);
  Block<TypeParam> block(1, 4, 4, 1, 1, 1, 1, {1e7, 0.45, 1700, peak});
  LawTable& t = block.laws;
  t.floor = {curve.floor};
  t.amplitude = {curve.amplitude};
  t.rate = {curve.rate};
  t.exp_end = {curve.exp_end};
  t.line_start = {curve.line_start};
  t.line_slope = {(curve.last - curve.line_start) / (curve.line_end - curve.exp_end)};
  t.line_end = {curve.line_end};
  t.last = {curve.last};
  t.softens = {1};
  Element<TypeParam> b(block);
  double largest = 0, off = 0;
  for (int i = 0; i < 100000; ++i) {
    const double gamma = first(b).plastic_strain;
    b.strain(0.5e-4, 0, 0, -0.5e-4, 1);
    const auto s = principal(first(b));
    largest = std::max(largest, (s[2] - s[0]) / 2);
    if (first(b).plastic_strain == gamma) continue;
    const double expected = gamma > 0 ? strength(curve, gamma) : peak;
    ASSERT_NEAR((s[2] - s[0]) / 2, expected, 1e-3 * peak) << "at plastic strain " << gamma;
    off = std::max(off, std::abs((s[2] - s[0]) / 2 - expected));
  }
  leda::test::record("largest ", 100 * off / peak, " % of s_up");
  EXPECT_NEAR(largest, peak, 0.01 * peak);  // the peak is held until the first yield
  EXPECT_NEAR(first(b).plastic_strain, 10, 0.05);
  const auto s = principal(first(b));
  EXPECT_NEAR((s[2] - s[0]) / 2, 736, 1);
}

}  // namespace
}  // namespace leda::solver::test
