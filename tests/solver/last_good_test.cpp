#include "solver/run/last_good.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/solver/block.hpp"

namespace leda::solver::test {
namespace {

Block block() { return Block(0.5, 4, 4, 1, 1, 2, 2, {}); }

TEST(LastGood, GivesEveryParticleItsOwnStateBackWhateverTheOrder) {
  Block b = block();
  Particles& p = b.particles;
  for (std::size_t i = 0; i < p.count; ++i) p.sxx[i] = 100 + p.id[i];
  LastGood good;
  ASSERT_TRUE(good.keep(p, 1.5));
  std::vector<std::int32_t> backwards(p.count);
  for (std::size_t i = 0; i < p.count; ++i) {
    backwards[i] = static_cast<std::int32_t>(p.count - 1 - i);
  }
  p.reorder(backwards);
  for (auto* array : {&p.x, &p.z, &p.vx, &p.sxx}) {
    std::fill(array->begin(), array->end(), std::numeric_limits<double>::quiet_NaN());
  }
  EXPECT_EQ(good.restore(p), 1.5);
  for (std::size_t i = 0; i < p.count; ++i) {
    EXPECT_EQ(p.sxx[i], 100 + p.id[i]);
    EXPECT_EQ(p.vx[i], 0);
    EXPECT_FLOAT_EQ(static_cast<float>(p.x[i]), static_cast<float>(p.start_x[i]));
  }
}

TEST(LastGood, KeepsWhatItHasWhereAValueIsNotFinite) {
  Block b = block();
  LastGood good;
  ASSERT_TRUE(good.keep(b.particles, 1));
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    for (auto array :
         {&Particles::x, &Particles::vz, &Particles::syy, &Particles::plastic_strain}) {
      Block broken = block();
      (broken.particles.*array)[3] = bad;
      EXPECT_FALSE(good.keep(broken.particles, 2));
    }
  }
  EXPECT_EQ(good.restore(b.particles), 1);
}

TEST(LastGood, NothingKeptRestoresNothing) {
  Block b = block();
  const std::vector<double> x = b.particles.x;
  LastGood().restore(b.particles);
  EXPECT_EQ(b.particles.x, x);
}

}  // namespace
}  // namespace leda::solver::test
