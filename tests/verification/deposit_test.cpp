#include <gtest/gtest.h>

#include "tests/solver/block.hpp"
#include "tests/verification/record.hpp"

namespace leda::solver::test {
namespace {

template <class Real>
class Deposit : public ::testing::Test {};
TYPED_TEST_SUITE(Deposit, BothPrecisions, PrecisionNames);

struct Shape {
  double front = 0, height = 0;
};

// A block of yield stress tau beside a wall without friction slumps slowly (local damping 0.7) on
// a base that sticks.
template <class Real>
Shape slump(double width, double height, double room, double tau, double cell) {
  const double unit_weight = 17000, g = 9.81, shear = 200 * tau, nu = 0.45;
  Block<Real> b(cell, room, 1.5 * height, 0, 0, width, height,
                {2 * shear * (1 + nu), nu, unit_weight / g, tau});
  for (Particle& p : b.particles) p.sxx = p.szz = p.syy = -unit_weight * (height - p.z);
  Model<Real> model = b.model();
  ThreadTeam team(1);
  const double dt = b.time_step();
  double calm = 0;
  for (int i = 0; i * dt < 400 && calm < 2; ++i) {
    if (i % 8 == 0) {
      EXPECT_TRUE(tidy_up(model));
    }
    const StepSums sums = step(model, {dt, g, 0.7, true}, false, team);
    calm = sums.points.fastest_squared < 1e-6 ? calm + dt : 0;
  }
  Shape d;
  for_each_point(model.packs, [&](std::size_t i, std::size_t l) {
    const PointAt at = point_at(model.packs, i, l, cell);
    d.front = std::max(d.front, at.x + cell / 4);
    if (at.x < 2 * cell) d.height = std::max(d.height, at.z + cell / 4);
  });
  return d;
}

// validation case bingham_or_remoulded_final_deposit (Liu and Mei 1989): a sheet at its yield
// stress ends with h^2 = 2 tau (L - x) / (rho g), L = (9 A^2 rho g / (8 tau))^(1/3), within 15 %.
TYPED_TEST(Deposit, SoftSheetComesToRestWhereItsYieldStressHoldsIt) {
  const Shape d = slump<TypeParam>(16, 3.125, 50, 1000, 0.25);
  leda::test::record("L ", d.front, " m, h ", d.height, " m");
  EXPECT_NEAR(d.front, 36.295, 0.15 * 36.295);
  EXPECT_NEAR(d.height, std::sqrt(2 * 1000 * 36.295 / 17000), 0.15 * 2.07);
}

TYPED_TEST(Deposit, ShorterSheetComesToRestWhereItsYieldStressHoldsIt) {
  const Shape d = slump<TypeParam>(6, 12.5 / 6, 20, 1500, 0.125);
  leda::test::record("L ", d.front, " m, h ", d.height, " m");
  EXPECT_NEAR(d.front, 12.5828, 0.15 * 12.5828);
  EXPECT_NEAR(d.height, std::sqrt(2 * 1500 * 12.5828 / 17000), 0.15 * 1.49);
}

}  // namespace
}  // namespace leda::solver::test
