#include <gtest/gtest.h>

#include "solver/run/audit.hpp"
#include "tests/solver/block.hpp"

namespace leda::solver::test {
namespace {

Block block_in_the_middle() { return Block(0.5, 10, 10, 3, 3, 3, 3, {}); }

TEST(Transfer, KeepsMassAndMomentum) {
  Block b = block_in_the_middle();
  for (std::size_t i = 0; i < b.particles.padded(); ++i) {
    b.particles.vx[i] = std::sin(3.0 * b.particles.x[i]);
    b.particles.vz[i] = std::cos(2.0 * b.particles.z[i]);
    b.particles.cxz[i] = 0.7;
  }
  const Balances balance = transfer_balance(b.particles, b.grid);
  EXPECT_LT(balance.mass, 1e-13);
  EXPECT_LT(balance.momentum, 1e-13);
}

// APIC hands an affine velocity field to the grid and back unchanged (Jiang et al. 2015, 5.2).
TEST(Transfer, KeepsAnAffineField) {
  Block b = block_in_the_middle();
  Particles& p = b.particles;
  for (std::size_t i = 0; i < p.padded(); ++i) {
    p.vx[i] = 1 + 0.2 * p.x[i] - 0.3 * p.z[i];
    p.vz[i] = -2 + 0.5 * p.x[i] + 0.1 * p.z[i];
    p.cxx[i] = 0.2;
    p.cxz[i] = -0.3;
    p.czx[i] = 0.5;
    p.czz[i] = 0.1;
  }
  const double dt = 1e-9;  // stresses stay nought
  step(p, b.grid, b.laws, {dt, 0.0, 0.0, true});
  for (std::size_t i = 0; i < p.count; ++i) {
    EXPECT_NEAR(p.vx[i], 1 + 0.2 * p.x[i] - 0.3 * p.z[i], 1e-7);
    EXPECT_NEAR(p.vz[i], -2 + 0.5 * p.x[i] + 0.1 * p.z[i], 1e-7);
    EXPECT_NEAR(p.cxz[i], -0.3, 1e-6);
    EXPECT_NEAR(p.czx[i], 0.5, 1e-6);
  }
}

// sum_i f_i . v_i = - sum_p V sigma : grad v, for any stress and any grid velocity.
void expect_conjugate(Block b) {
  Particles& p = b.particles;
  for (std::size_t i = 0; i < p.padded(); ++i) {
    p.sxx[i] = 1e3 * std::sin(p.x[i]);
    p.szz[i] = 2e3 * std::cos(p.z[i]);
    p.sxz[i] = 5e2 * std::sin(p.x[i] + p.z[i]);
  }
  clear(b.grid);
  particles_to_grid(p, b.grid);
  double power = 0;
  for (std::size_t i = 0; i < b.grid.columns * b.grid.rows; ++i) {
    const double vx = std::sin(0.1 * static_cast<double>(i)),
                 vz = std::cos(0.3 * static_cast<double>(i));
    b.grid.velocity[2 * i] = vx;
    b.grid.velocity[2 * i + 1] = vz;
    power += b.grid.node[i * Grid::width + 3] * vx + b.grid.node[i * Grid::width + 4] * vz;
  }
  const double dt = 1e-12;  // the stress of the step is the stress given
  const ParticleSums sums = grid_to_particles(p, b.grid, b.laws, dt, false);
  EXPECT_NEAR(sums.stress_work / dt, -power, 1e-6 * std::abs(power));
}

TEST(Transfer, ForceAndGradientAreConjugate) { expect_conjugate(block_in_the_middle()); }

// B-bar (Hughes 1980) averages dilation; only with the pressure averaged alike no work is lost.
TEST(Transfer, AveragedPressureAndDilationAreConjugate) {
  Block b = block_in_the_middle();
  for (std::size_t i = 0; i < b.particles.count; ++i) {  // particles of unequal size and place
    b.particles.volume[i] *= 1 + 0.4 * std::sin(7 * static_cast<double>(i));
    b.particles.x[i] += 0.1 * b.grid.h * std::sin(3 * static_cast<double>(i));
  }
  average_spans(b.grid);
  expect_conjugate(b);
}

// A span strains as a whole: its particles change their pressure alike, by K times its mean
// dilation, whatever each would have seen alone.
TEST(Transfer, ParticlesOfASpanShareItsDilation) {
  Block b(1, 6, 6, 2.5, 2.5, 1, 1, {1e6, 0.499, 1000, 1e30});
  average_spans(b.grid);
  clear(b.grid);
  particles_to_grid(b.particles, b.grid);
  for (std::size_t i = 0; i < b.grid.columns * b.grid.rows; ++i) {
    b.grid.velocity[2 * i] = std::sin(static_cast<double>(i));
    b.grid.velocity[2 * i + 1] = std::cos(2 * static_cast<double>(i));
  }
  grid_to_particles(b.particles, b.grid, b.laws, 1e-3, false);
  const Particles& p = b.particles;
  ASSERT_EQ(p.count, 4U);
  const auto mean = [&](std::size_t i) { return (p.sxx[i] + p.szz[i] + p.syy[i]) / 3; };
  EXPECT_GT(std::abs(mean(0)), 1);
  for (std::size_t i = 1; i < p.count; ++i) {
    EXPECT_NEAR(mean(i), mean(0), 1e-9 * std::abs(mean(0)));
    EXPECT_GT(std::abs(p.sxx[i] - p.sxx[0]), 1);
  }
}

TEST(Transfer, CarriesStressFreeParticlesAcrossSortsInAnyOrder) {
  Block b = block_in_the_middle();
  const double before = b.particles.mass[0] * static_cast<double>(b.particles.count);
  std::fill(b.particles.vx.begin(), b.particles.vx.end(), 2.0);
  b.run(200, {1e-3, 0.0, 0.0, true});
  double after = 0;
  for (std::size_t i = 0; i < b.particles.count; ++i) after += b.particles.mass[i];
  EXPECT_DOUBLE_EQ(after, before);
  for (std::size_t i = 0; i < b.particles.count; ++i) {
    EXPECT_NEAR(b.particles.x[i], b.particles.start_x[i] + 0.4, 1e-9);
  }
}

}  // namespace
}  // namespace leda::solver::test
