#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "solver/materials/softening.hpp"
#include "tests/solver/block.hpp"
#include "tests/verification/record.hpp"

namespace leda::solver::test {
namespace {

Block element(const BlockMaterial& m) { return Block(1, 4, 4, 1, 1, 1, 1, m); }

std::array<double, 3> principal(const Particles& p) {
  const double c = (p.sxx[0] + p.szz[0]) / 2;
  const double r = std::hypot((p.sxx[0] - p.szz[0]) / 2, p.sxz[0]);
  std::array<double, 3> s{c + r, c - r, p.syy[0]};
  std::sort(s.begin(), s.end());
  return s;
}

// validation case simple_shear_jaumann (Dienes 1979): sxz = G sin(gamma), sxx = G (1 - cos(gamma)).
TEST(Tresca, ElasticSimpleShearIsThatOfTheJaumannRate) {
  const double g = 1e6;
  Block b = element({2.6e6, 0.3, 1000, 1e30});
  const int steps = 4000;
  double off = 0;
  for (int i = 0; i < 4 * steps; ++i) {
    b.strain(0, 1, 0, 0, 0.5 / steps);
    const double gamma = 0.5 * (i + 1) / steps;
    if ((i + 1) % steps != 0) continue;
    EXPECT_NEAR(b.particles.sxz[0], g * std::sin(gamma), 1e-3 * g);
    EXPECT_NEAR(b.particles.sxx[0], g * (1 - std::cos(gamma)), 1e-3 * g);
    EXPECT_NEAR(b.particles.szz[0], -b.particles.sxx[0], 1e-6 * g);
    off = std::max({off, std::abs(b.particles.sxz[0] / g - std::sin(gamma)),
                    std::abs(b.particles.sxx[0] / g - 1 + std::cos(gamma))});
  }
  leda::test::record("largest ", 100 * off, " % of G");
}

// validation case von_mises_vs_tresca_plane_strain: flow without volume change at radius s_u,
// out-of-plane stress in the middle of the in-plane ones.
TEST(Tresca, PlaneFlowHasTheUndrainedStrength) {
  Block b = element({1e7, 0.45, 1700, 40500});
  for (int i = 0; i < 1000; ++i) b.strain(1e-4, 0, 0, -1e-4, 1);
  const auto s = principal(b.particles);
  EXPECT_NEAR(s[2] - s[0], 2 * 40500.0, 1);
  EXPECT_NEAR(s[1], 0.5 * (s[0] + s[2]), 1);
  leda::test::record("strength off by ", 100 * std::abs((s[2] - s[0]) / 81000.0 - 1),
                     " %, middle stress by ", 100 * std::abs(s[1] - 0.5 * (s[0] + s[2])) / 40500,
                     " % of s_u");
}

// Closed form: after first yield at gamma_y = s_u / G, all further shear is plastic.
TEST(Tresca, PlasticStrainIsTheShearBeyondYield) {
  const double g = 1e7 / 2.9, s = 40500;
  Block b = element({1e7, 0.45, 1700, s});
  const double total = 0.1;
  for (int i = 0; i < 1000; ++i) b.strain(total / 2000, 0, 0, -total / 2000, 1);
  EXPECT_NEAR(b.particles.plastic_strain[0], total - s / g, 1e-4 * total);
}

// The edges of the 3D surface: extension out of plane brings two principal stresses together;
// the mean stress is that of elasticity, and the surface is never left.
TEST(Tresca, CornersAreReachedAndKeepTheMean) {
  for (const double sign : {1.0, -1.0}) {
    Block b = element({1e7, 0.3, 1700, 1e4});
    std::fill(b.particles.syy.begin(), b.particles.syy.end(), sign * 5e4);
    const double bulk = b.laws.bulk[0];
    double mean = sign * 5e4 / 3;
    b.strain(0, 0, 0, 0, 1);
    for (int i = 0; i < 50; ++i) {
      b.strain(sign * -1e-4, 1e-5, 0, sign * -1e-4, 1);
      mean -= sign * bulk * 2e-4;
      const auto s = principal(b.particles);
      EXPECT_LE(s[2] - s[0], 2e4 * (1 + 1e-9));
      EXPECT_NEAR((s[0] + s[1] + s[2]) / 3, mean, 1e-6 * 5e4);
    }
    const auto s = principal(b.particles);
    EXPECT_GT(s[2] - s[0], 2e4 * (1 - 1e-6));
  }
}

// Eq. 4-2 along the whole curve, by an element in the very kernel of the solver: the law's value
// at the plastic strain of the step's start, within one step's softening (0.1 % of s_up).
TEST(Tresca, SofteningElementFollowsEquation42) {
  UrmiSoftening law;
  law.alpha = 0.95;
  law.beta = 2.8;
  law.residual_strain = 1.8;
  law.remolded_strength_Pa = 736;
  Softening softening{law, 0.014, Regularization::none};
  const double peak = 40500;
  const SofteningCurve curve = softening_curve(softening, peak, 1.0);
  Block b = element({1e7, 0.45, 1700, peak});
  LawTable& t = b.laws;
  t.floor = {curve.floor};
  t.amplitude = {curve.amplitude};
  t.rate = {curve.rate};
  t.exp_end = {curve.exp_end};
  t.line_start = {curve.line_start};
  t.line_slope = {(curve.last - curve.line_start) / (curve.line_end - curve.exp_end)};
  t.line_end = {curve.line_end};
  t.last = {curve.last};
  t.softens = {1};
  double largest = 0, off = 0;
  for (int i = 0; i < 100000; ++i) {
    const double gamma = b.particles.plastic_strain[0];
    b.strain(0.5e-4, 0, 0, -0.5e-4, 1);
    const auto s = principal(b.particles);
    largest = std::max(largest, (s[2] - s[0]) / 2);
    if (b.particles.plastic_strain[0] == gamma) continue;
    const double expected = gamma > 0 ? strength(curve, gamma) : peak;
    ASSERT_NEAR((s[2] - s[0]) / 2, expected, 1e-3 * peak) << "at plastic strain " << gamma;
    off = std::max(off, std::abs((s[2] - s[0]) / 2 - expected));
  }
  leda::test::record("largest ", 100 * off / peak, " % of s_up");
  EXPECT_NEAR(largest, peak, 0.01 * peak);  // the peak is held until the first yield
  EXPECT_NEAR(b.particles.plastic_strain[0], 10, 0.05);
  const auto s = principal(b.particles);
  EXPECT_NEAR((s[2] - s[0]) / 2, 736, 1);
}

}  // namespace
}  // namespace leda::solver::test
