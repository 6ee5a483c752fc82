#include "solver/run/seed_particles.hpp"

#include <gtest/gtest.h>

#include "solver/section/overburden.hpp"
#include "tests/solver/bank.hpp"

namespace leda::solver::test {
namespace {

TEST(SeedParticles, FillTheSectionWithItsMass) {
  const Section s = bank(10, 45, 20e3);
  const Seeded seeded = seed_particles(s, {0.5, 4, 0});
  double mass = 0;
  for (std::size_t i = 0; i < seeded.particles.size(); ++i) mass += seeded.particles[i].mass;
  // 40 x 13 plateau, 10 x 13 - 50 face, 30 x 3 floor
  const double area = 520 + 80 + 90;
  EXPECT_NEAR(mass, area * 17e3 / gravity, 0.01 * area * 17e3 / gravity);
}

TEST(SeedParticles, K0ActsOnEffectiveStress) {
  const Section s = bank(10, 45, 20e3);
  const Seeded seeded = seed_particles(s, {1, 4, 0});
  const Particles& p = seeded.particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p[i].x > 39) continue;
    const double depth = 13 - p[i].z;
    const double vertical = 17e3 * depth, u = water_unit_weight * depth;
    EXPECT_NEAR(p[i].szz, -vertical, 1e-6 * vertical);
    EXPECT_NEAR(p[i].sxx, -(0.5 * (vertical - u) + u), 1e-6 * vertical);
    EXPECT_DOUBLE_EQ(p[i].syy, p[i].sxx);
  }
}

TEST(SeedParticles, OverburdenAddsUpTheLayers) {
  Section s = bank(10, 45, 20e3);
  Material crust = s.materials["clay"];
  crust.unit_weight = 19e3;
  s.materials["crust"] = crust;
  Layer top;
  top.material = "crust";
  top.thickness_m = 2;
  s.layers.insert(s.layers.begin(), top);
  EXPECT_NEAR(overburden(s, {5, 5}), 2 * 19e3 + 3 * 17e3, 1e-6);
  EXPECT_NEAR(overburden(s, {5, 9}), 19e3, 1e-6);
}

TEST(SeedParticles, ColumnsOfTheSameSoilAreTheSameGround) {
  const Section s = bank(5, 45, 20e3);
  Section split = s;
  split.columns = {{0, 33.3, s.layers}, {33.3, 75, s.layers}};
  split.layers.clear();
  const Seeded a = seed_particles(s, {1, 4, 3}), b = seed_particles(split, {1, 4, 3});
  ASSERT_EQ(a.particles.size(), b.particles.size());
  for (std::size_t i = 0; i < a.particles.size(); ++i) {
    EXPECT_EQ(a.particles[i].x, b.particles[i].x);
    EXPECT_EQ(a.particles[i].szz, b.particles[i].szz);
    EXPECT_EQ(a.particles[i].law, b.particles[i].law);
  }
}

TEST(SeedParticles, EachColumnHasItsMaterial) {
  Section s = bank(5, 45, 20e3);
  s.materials["fill"] = s.materials["clay"];
  s.materials["fill"].unit_weight = 20e3;
  Layer fill;
  fill.material = "fill";
  s.columns = {{0, 20, s.layers}, {20, 75, {fill}}};
  s.layers.clear();
  const Seeded seeded = seed_particles(s, {1, 4, 0});
  for (std::size_t i = 0; i < seeded.particles.size(); ++i) {
    const double weight = seeded.particles[i].x < 20 ? 17e3 : 20e3;
    EXPECT_NEAR(seeded.particles[i].mass, weight / gravity * 0.25, 1e-9 * weight);
  }
}

TEST(SeedParticles, ASeedMovesThemByAMicrometreAtMost) {
  const Section s = bank(5, 45, 20e3);
  const Seeded a = seed_particles(s, {1, 4, 0}), b = seed_particles(s, {1, 4, 7});
  ASSERT_EQ(a.particles.size(), b.particles.size());
  double most = 0;
  for (std::size_t i = 0; i < a.particles.size(); ++i) {
    most = std::max(most, std::abs(a.particles[i].x - b.particles[i].x));
  }
  EXPECT_GT(most, 1e-8);
  EXPECT_LE(most, 1e-6);
}

TEST(SeedParticles, NineParticlesACellStandOnAThirdOfACell) {
  const Section s = bank(5, 45, 20e3);
  const Seeded seeded = seed_particles(s, {1, 9, 0});
  EXPECT_NEAR(seeded.spacing, 1.0 / 3, 1e-12);
  EXPECT_NEAR(seeded.particles[0].volume, 1.0 / 9, 1e-12);
}

}  // namespace
}  // namespace leda::solver::test
