// Ground that would limit the time step, and what makes it softer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/solver/block.hpp"

namespace leda::solver::test {
namespace {

// The quadratic B-spline (Steffen et al. 2008), distance in cells.
double spline(double distance) {
  const double d = std::abs(distance);
  if (d < 0.5) return 0.75 - d * d;
  return d < 1.5 ? 0.5 * (1.5 - d) * (1.5 - d) : 0.0;
}

// How full the cell is that particle i sees: sum over all particles j of w_i w_j V_j / h^2, both
// weights at the same node. All have the same volume.
double fill_at(const Particles& p, std::size_t i, double h) {
  double fill = 0;
  for (int column = 0; column < 30; ++column) {
    for (int row = 0; row < 30; ++row) {
      const double own = spline(p[i].x / h - column) * spline(p[i].z / h - row);
      if (own == 0) continue;
      for (std::size_t j = 0; j < p.size(); ++j) {
        fill += own * spline(p[j].x / h - column) * spline(p[j].z / h - row) * p[j].volume;
      }
    }
  }
  return fill / (h * h);
}

// Stress after one step of even stretching, over that of the moduli as they are.
template <class Real>
std::vector<double> stiffness_found(Block<Real>& b, bool softer) {
  constexpr double stretch = 1e-3;  // 1/s
  for (Particle& p : b.particles) {
    p.vx = stretch * p.x;
    p.cxx = stretch;
  }
  b.settings.softer = softer;
  const double dt = b.time_step();
  b.run(1, {dt, 0, 0, true});
  const double modulus = b.laws.bulk[0] + 4.0 / 3.0 * b.laws.shear[0];
  std::vector<double> found;
  for (const Particle& p : b.particles) found.push_back(p.sxx / (modulus * stretch * dt));
  return found;
}

// A block on its own, off the cells' corners, with a particle alone beside it.
template <class Real>
Block<Real> block_and_loner() {
  Block<Real> b(1, 24, 24, 8.1, 8.2, 4, 4, {});
  b.particles.back().x = 16.3;
  b.particles.back().z = 16.4;
  return b;
}

template <class Real>
class Softer : public ::testing::Test {};
TYPED_TEST_SUITE(Softer, BothPrecisions, PrecisionNames);

// Single precision: velocities of 1e-2 m/s differ by 1e-3 from node to node, 24 bits leave 1e-6.
template <class Real>
constexpr double rounding = sizeof(Real) == 4 ? 1e-4 : 1e-9;

TYPED_TEST(Softer, ThinGroundHasTheStatedShareOfItsModuli) {
  auto b = block_and_loner<TypeParam>();
  std::vector<double> fill(b.particles.size());
  for (std::size_t i = 0; i < fill.size(); ++i) fill[i] = fill_at(b.particles, i, 1);
  EXPECT_LT(*std::ranges::min_element(fill), 0.15);  // the one alone
  EXPECT_GT(*std::ranges::max_element(fill), 0.99);  // the middle of the block
  const auto found = stiffness_found(b, true);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double share = fill[i] / 0.8;
    EXPECT_NEAR(found[i], std::clamp(share * share, 0.25, 1.0), rounding<TypeParam>)
        << i << ' ' << fill[i];
  }
}

TYPED_TEST(Softer, WithoutItAllGroundKeepsItsModuli) {
  auto b = block_and_loner<TypeParam>();
  for (const double found : stiffness_found(b, false)) {
    EXPECT_NEAR(found, 1, rounding<TypeParam>);
  }
}

TYPED_TEST(Softer, StrainedGroundLosesUpToAThird) {
  Block<TypeParam> b(1, 24, 24, 8.1, 8.2, 4, 4, {});
  for (std::size_t i = 0; i < b.particles.size(); ++i) {
    b.particles[i].plastic_strain = 0.5 * static_cast<double>(i % 4);
  }
  const Particles before = b.particles;
  const auto evenly = stiffness_found(b, true);
  Block<TypeParam> unstrained(1, 24, 24, 8.1, 8.2, 4, 4, {});
  const auto whole = stiffness_found(unstrained, true);
  for (std::size_t i = 0; i < evenly.size(); ++i) {
    EXPECT_NEAR(evenly[i] / whole[i], 1 - 0.35 * std::min(before[i].plastic_strain, 1.0),
                2 * rounding<TypeParam>);
  }
}

// The images beyond an edge count: ground at the base and at the sides is not thin.
TYPED_TEST(Softer, GroundAtTheEdgesIsNotThin) {
  Block<TypeParam> b(1, 8, 8, 0, 0, 8, 4, {}), as_it_is = b;
  const auto found = stiffness_found(b, true), expected = stiffness_found(as_it_is, false);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (b.particles[i].z > 2.5) continue;  // the free surface
    EXPECT_NEAR(found[i], expected[i], rounding<TypeParam>)
        << b.particles[i].x << ' ' << b.particles[i].z;
  }
}

}  // namespace
}  // namespace leda::solver::test
