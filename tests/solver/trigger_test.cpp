#include "solver/run/trigger.hpp"

#include <gtest/gtest.h>

#include "solver/run/initial_stress.hpp"
#include "tests/solver/bank.hpp"

namespace leda::solver::test {
namespace {

TEST(Trigger, AToeCutStandsWhereTheGroundIsThatHigh) {
  const Section s = bank(10, 45, 20e3);
  const Polyline cut = toe_cut(s, {{40, 10}, {50, 0}}, 3);
  EXPECT_NEAR(cut[1].x, 47, 0.01);  // 45 degrees: 3 m behind the toe the ground is 3 m high
  EXPECT_TRUE(is_inside(cut, {48, 1}));
  EXPECT_FALSE(is_inside(cut, {46.5, 1}));
  EXPECT_FALSE(is_inside(cut, {48, -0.5}));
}

TEST(Trigger, ExcavationTakesAwayTheParticlesInside) {
  const Section s = bank(10, 45, 20e3);
  RunState run;
  run.seeded = seed_particles(s, {1, 4, 0});
  begin_quiet(run);
  const std::size_t before = particles_of(run.model).size();
  // A square of 2 m of the plateau: 4 m2 are 16 particles.
  EXPECT_EQ(excavate(run, {{10, 6}, {12, 6}, {12, 8}, {10, 8}}), 16U);
  const Particles left = particles_of(run.model);
  EXPECT_EQ(left.size(), before - 16);
  for (const Particle& p : left) {
    EXPECT_FALSE(p.x > 10 && p.x < 12 && p.z - 3 > 6 && p.z - 3 < 8);
  }
  EXPECT_EQ(excavate(run, {{200, 6}, {202, 6}, {202, 8}}), 0U);
}

}  // namespace
}  // namespace leda::solver::test
