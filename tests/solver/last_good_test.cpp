#include "solver/run/last_good.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/solver/block.hpp"

namespace leda::solver::test {
namespace {

Block<float> block() { return Block<float>(0.5, 4, 4, 1, 1, 2, 2, {}); }

TEST(LastGood, GivesEveryParticleItsOwnStateBackWhateverTheOrder) {
  Block b = block();
  for (Particle& p : b.particles) p.sxx = 100 + p.id;
  LastGood good;
  ASSERT_TRUE(good.keep(b.model(), 1.5));
  Particles broken = b.particles;
  std::ranges::reverse(broken);
  for (Particle& p : broken) p.x = p.z = p.vx = p.sxx = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(good.restore(broken), 1.5);
  for (const Particle& p : broken) {
    EXPECT_EQ(p.sxx, 100 + p.id);
    EXPECT_EQ(p.vx, 0);
    EXPECT_FLOAT_EQ(static_cast<float>(p.x),
                    static_cast<float>(b.start[static_cast<std::size_t>(p.id)].x));
  }
}

TEST(LastGood, KeepsWhatItHasWhereAValueIsNotFinite) {
  Block b = block();
  LastGood good;
  ASSERT_TRUE(good.keep(b.model(), 1));
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    for (auto number : {&Particle::vz, &Particle::syy, &Particle::plastic_strain}) {
      Block<double> broken(0.5, 4, 4, 1, 1, 2, 2, {});
      broken.particles[3].*number = bad;
      EXPECT_FALSE(good.keep(broken.model(), 2));
    }
  }
  EXPECT_EQ(good.restore(b.particles), 1);
}

TEST(LastGood, NothingKeptRestoresNothing) {
  Block b = block();
  LastGood().restore(b.particles);
  EXPECT_EQ(b.particles[5].x, b.start[5].x);
}

}  // namespace
}  // namespace leda::solver::test
