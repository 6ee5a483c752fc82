// What the transfers between points and nodes keep.
#include <gtest/gtest.h>

#include "tests/solver/block.hpp"

namespace leda::solver::test {
namespace {

template <class Real>
class Transfer : public ::testing::Test {
 protected:
  static Block<Real> block_in_the_middle() { return Block<Real>(0.5, 10, 10, 3, 3, 3, 3, {}); }

  static StepSums one_step(Model<Real>& model, const StepSettings& settings) {
    ThreadTeam team(1);
    return step(model, settings, true, team);
  }
};
TYPED_TEST_SUITE(Transfer, BothPrecisions, PrecisionNames);

TYPED_TEST(Transfer, KeepsMassAndMomentum) {
  auto b = this->block_in_the_middle();
  for (Particle& p : b.particles) {
    p.vx = std::sin(3.0 * p.x);
    p.vz = std::cos(2.0 * p.z);
    p.cxz = 0.7;
  }
  auto model = b.model();
  const Balances balance = transfer_balance(model);
  EXPECT_LT(balance.mass, within<TypeParam>(1e-6, 1e-13));
  EXPECT_LT(balance.momentum, within<TypeParam>(1e-6, 1e-13));
}

// APIC hands an affine velocity field to the grid and back unchanged (Jiang et al. 2015, 5.2).
TYPED_TEST(Transfer, KeepsAnAffineField) {
  auto b = this->block_in_the_middle();
  for (Particle& p : b.particles) {
    p.vx = 1 + 0.2 * p.x - 0.3 * p.z;
    p.vz = -2 + 0.5 * p.x + 0.1 * p.z;
    p.cxx = 0.2;
    p.cxz = -0.3;
    p.czx = 0.5;
    p.czz = 0.1;
  }
  b.run(1, {1e-9, 0.0, 0.0, true});  // stresses stay nought
  const double t = within<TypeParam>(1e-5, 1e-7);
  for (const Particle& p : b.particles) {
    EXPECT_NEAR(p.vx, 1 + 0.2 * p.x - 0.3 * p.z, t);
    EXPECT_NEAR(p.vz, -2 + 0.5 * p.x + 0.1 * p.z, t);
    EXPECT_NEAR(p.cxz, -0.3, 10 * t);
    EXPECT_NEAR(p.czx, 0.5, 10 * t);
  }
}

// sum_i f_i . v_i = - sum_p V sigma : grad v, for any stress and any velocity of the nodes.
template <class Real>
void expect_conjugate(Block<Real> b) {
  for (Particle& p : b.particles) {
    p.sxx = 1e3 * std::sin(p.x);
    p.szz = 2e3 * std::cos(p.z);
    p.sxz = 5e2 * std::sin(p.x + p.z);
  }
  b.settings.keeps_force = true;
  Element<Real> e(b);
  balance_nodes(e.model, {0, 0, 0, false}, e.team);
  const auto velocity = [](double x, double z) {
    return std::pair(std::sin(3 * x + z), std::cos(2 * z - x));
  };
  double power = 0;
  auto& grid = e.model.grid;
  for (std::size_t i = 1; i + 1 < grid.columns; ++i) {
    for (std::size_t k = 1; k < grid.top[i]; ++k) {
      const auto [vx, vz] =
          velocity((static_cast<double>(i) - 1) * grid.h, (static_cast<double>(k) - 1) * grid.h);
      const Real* force = grid.force_at(i, k);
      power += static_cast<double>(force[0]) * vx + static_cast<double>(force[grid.stride]) * vz;
    }
  }
  const double dt = 1e-12;  // the stress of the step is the stress given
  const PointSums sums = e.strain(dt, velocity);
  EXPECT_NEAR(sums.stress_work / dt, -power, within<Real>(1e-5, 1e-6) * std::abs(power));
}

TYPED_TEST(Transfer, ForceAndGradientAreConjugate) {
  expect_conjugate(this->block_in_the_middle());
}

// B-bar (Hughes 1980) averages dilation; only with the pressure averaged alike no work is lost.
TYPED_TEST(Transfer, AveragedPressureAndDilationAreConjugate) {
  auto b = this->block_in_the_middle();
  for (std::size_t i = 0; i < b.particles.size(); ++i) {  // particles of unequal size and place
    b.particles[i].volume *= 1 + 0.4 * std::sin(7 * static_cast<double>(i));
    b.particles[i].x += 0.1 * b.size.h * std::sin(3 * static_cast<double>(i));
  }
  b.settings.averages = true;
  expect_conjugate(b);
}

// A span strains as a whole: its particles change their pressure alike, by K times its mean
// dilation, whatever each would have seen alone.
TYPED_TEST(Transfer, ParticlesOfASpanShareItsDilation) {
  Block<TypeParam> b(1, 6, 6, 2.5, 2.5, 1, 1, {1e6, 0.499, 1000, 1e30});
  b.settings.averages = true;
  Element<TypeParam> e(b);
  e.strain(1e-3, [](double x, double z) {
    return std::pair(std::sin(7 * x + z), std::cos(14 * z - 3 * x));
  });
  const Particles p = e.particles();
  ASSERT_EQ(p.size(), 4U);
  const auto mean = [&](std::size_t i) { return (p[i].sxx + p[i].szz + p[i].syy) / 3; };
  EXPECT_GT(std::abs(mean(0)), 1);
  for (std::size_t i = 1; i < p.size(); ++i) {
    EXPECT_NEAR(mean(i), mean(0), within<TypeParam>(1e-5, 1e-9) * std::abs(mean(0)));
    EXPECT_GT(std::abs(p[i].sxx - p[0].sxx), 1);
  }
}

TYPED_TEST(Transfer, CarriesStressFreeParticlesFromCellToCell) {
  auto b = this->block_in_the_middle();
  for (Particle& p : b.particles) p.vx = 2;
  b.run(200, {1e-3, 0.0, 0.0, true});
  ASSERT_EQ(b.particles.size(), b.start.size());
  for (std::size_t i = 0; i < b.particles.size(); ++i) {
    EXPECT_EQ(b.particles[i].mass, static_cast<TypeParam>(b.start[i].mass));
    EXPECT_NEAR(b.particles[i].x, b.start[i].x + 0.4, within<TypeParam>(1e-5, 1e-9));
  }
}

}  // namespace
}  // namespace leda::solver::test
