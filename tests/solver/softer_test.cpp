// Ground that would limit the time step, and what makes it softer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/kernel/packed_stage.hpp"
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
      const double own = spline(p.x[i] / h - column) * spline(p.z[i] / h - row);
      if (own == 0) continue;
      for (std::size_t j = 0; j < p.count; ++j) {
        fill += own * spline(p.x[j] / h - column) * spline(p.z[j] / h - row) * p.volume[j];
      }
    }
  }
  return fill / (h * h);
}

// Stress after one step of even stretching, over that of the moduli as they are.
std::vector<double> stiffness_found(Block& b, bool softer) {
  constexpr double stretch = 1e-3;  // 1/s
  for (std::size_t i = 0; i < b.particles.count; ++i) {
    b.particles.vx[i] = stretch * b.particles.x[i];
    b.particles.cxx[i] = stretch;
  }
  auto stage = begin_packed_stage(b.particles, b.grid, b.laws, softer);
  EXPECT_TRUE(stage);
  const double dt = b.time_step();
  Team team(1);
  bool left = false;
  step(*stage, {dt, 0, 0, true}, true, team, left);
  unpack(stage->packs, stage->grid, b.particles);
  const double modulus = b.laws.bulk[0] + 4.0 / 3.0 * b.laws.shear[0];
  std::vector<double> found(b.particles.count);
  for (std::size_t i = 0; i < found.size(); ++i) {
    found[i] = b.particles.sxx[i] / (modulus * stretch * dt);
  }
  return found;
}

// A block on its own, off the cells' corners, with a particle alone beside it.
Block block_and_loner() {
  Block b(1, 24, 24, 8.1, 8.2, 4, 4, {});
  Particles& p = b.particles;
  const std::size_t last = p.count - 1;
  p.x[last] = 16.3;
  p.z[last] = 16.4;
  p.fill_padding();
  EXPECT_TRUE(sort_particles(p, b.grid));
  return b;
}

// Single precision: velocities of 1e-2 m/s differ by 1e-3 from node to node, 24 bits leave 1e-6.
constexpr double rounding = 1e-4;

TEST(Softer, ThinGroundHasTheStatedShareOfItsModuli) {
  Block b = block_and_loner();
  std::vector<double> fill(b.particles.count);
  for (std::size_t i = 0; i < fill.size(); ++i) fill[i] = fill_at(b.particles, i, 1);
  EXPECT_LT(*std::ranges::min_element(fill), 0.15);  // the one alone
  EXPECT_GT(*std::ranges::max_element(fill), 0.99);  // the middle of the block
  const auto found = stiffness_found(b, true);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double share = fill[i] / 0.8;
    EXPECT_NEAR(found[i], std::clamp(share * share, 0.25, 1.0), rounding) << i << ' ' << fill[i];
  }
}

TEST(Softer, WithoutItAllGroundKeepsItsModuli) {
  Block b = block_and_loner();
  for (const double found : stiffness_found(b, false)) EXPECT_NEAR(found, 1, rounding);
}

TEST(Softer, StrainedGroundLosesUpToAThird) {
  Block b(1, 24, 24, 8.1, 8.2, 4, 4, {});
  for (std::size_t i = 0; i < b.particles.count; ++i) {
    b.particles.plastic_strain[i] = 0.5 * static_cast<double>(i % 4);
  }
  const auto strain = b.particles.plastic_strain;
  const auto evenly = stiffness_found(b, true);
  Block unstrained(1, 24, 24, 8.1, 8.2, 4, 4, {});
  const auto whole = stiffness_found(unstrained, true);
  for (std::size_t i = 0; i < evenly.size(); ++i) {
    EXPECT_NEAR(evenly[i] / whole[i], 1 - 0.35 * std::min(strain[i], 1.0), 2 * rounding);
  }
}

// The images beyond an edge count: ground at the base and at the sides is not thin.
TEST(Softer, GroundAtTheEdgesIsNotThin) {
  Block b(1, 8, 8, 0, 0, 8, 4, {}), as_it_is = b;
  const auto found = stiffness_found(b, true), expected = stiffness_found(as_it_is, false);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (b.particles.z[i] > 2.5) continue;  // the free surface
    EXPECT_NEAR(found[i], expected[i], rounding) << b.particles.x[i] << ' ' << b.particles.z[i];
  }
}

}  // namespace
}  // namespace leda::solver::test
