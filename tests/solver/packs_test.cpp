// The packed step against the double reference, and what packing keeps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "hwy/targets.h"
#include "solver/kernel/packed_stage.hpp"
#include "solver/run/simulate.hpp"
#include "tests/solver/bank.hpp"
#include "tests/solver/moving_bank.hpp"

namespace leda::solver::test {
namespace {

constexpr double dt = 1e-3;

StepSums steps(PackedStage& stage, int count) {
  StepSums sums;
  Team team(1);
  bool left = false;
  for (int i = 1; i <= count; ++i) {
    sums = step(stage, {dt, gravity, 0.02, true}, i == count, team, left);
    EXPECT_FALSE(left);
  }
  return sums;
}

// Single precision has 24 bits: 6e-8 of a value, and stresses are differences of values up to ten
// times as large; a hundred roundings in one direction stay below 1e-5.
TEST(Packs, StepAsTheReferenceDoes) {
  Seeded reference = moving_bank();
  Seeded packed = reference;
  auto stage = begin_packed_stage(packed.particles, packed.grid, packed.laws);
  ASSERT_TRUE(stage);
  StepSums expected;
  constexpr int count = 5;
  for (int i = 0; i < count; ++i) {
    expected = step(reference.particles, reference.grid, reference.laws, {dt, gravity, 0.02, true});
  }
  const StepSums found = steps(*stage, count);
  unpack(stage->packs, stage->grid, packed.particles);
  const Particles &p = packed.particles, &q = reference.particles;
  EXPECT_EQ(p.id, q.id);
  EXPECT_LT(difference(p.x, q.x, p.count), 1e-7);
  EXPECT_LT(difference(p.z, q.z, p.count), 1e-7);
  EXPECT_LT(difference(p.vx, q.vx, p.count), 1e-5);
  EXPECT_LT(difference(p.vz, q.vz, p.count), 1e-5);
  EXPECT_LT(difference(p.sxx, q.sxx, p.count), 1e-5);
  EXPECT_LT(difference(p.szz, q.szz, p.count), 1e-5);
  EXPECT_LT(difference(p.sxz, q.sxz, p.count), 1e-5);
  EXPECT_LT(difference(p.syy, q.syy, p.count), 1e-5);
  EXPECT_LT(difference(p.volume, q.volume, p.count), 1e-6);
  EXPECT_LT(difference(p.plastic_strain, q.plastic_strain, p.count), 1e-5);
  EXPECT_LT(difference(p.cxz, q.cxz, p.count), 1e-4);
  EXPECT_NEAR(found.grid.kinetic_before / expected.grid.kinetic_before, 1, 1e-5);
  EXPECT_NEAR(found.grid.kinetic_after / expected.grid.kinetic_after, 1, 1e-5);
  EXPECT_NEAR(found.grid.damping_work / expected.grid.damping_work, 1, 1e-4);
  EXPECT_NEAR(found.particles.stress_work / expected.particles.stress_work, 1, 1e-4);
  EXPECT_NEAR(found.particles.momentum_z / expected.particles.momentum_z, 1, 1e-5);
  EXPECT_NEAR(found.particles.fastest_squared / expected.particles.fastest_squared, 1, 1e-5);
}

// Points carried out of their cells are served one by one until they are put into their new cells;
// both ways must lead to the same motion, but for the order of sums.
TEST(Packs, StraysMoveAsIfTheyHadBeenArranged) {
  const Seeded s = moving_bank();
  auto strayed = begin_packed_stage(s.particles, s.grid, s.laws);
  ASSERT_TRUE(strayed);
  std::mt19937 random(7);
  PackedStage& stage = *strayed;
  shake(stage.packs, stage.grid, random);
  std::fill(stage.grid.sums.begin(), stage.grid.sums.end(), Real{0});
  PackedStage arranged = stage;
  spread_all(stage);
  spread_all(arranged);
  ASSERT_TRUE(tidy_up(arranged));
  steps(stage, 3);
  steps(arranged, 3);
  EXPECT_GT(stage.strayed, 300U);
  Particles a = s.particles, b = s.particles;
  unpack(stage.packs, stage.grid, a);
  unpack(arranged.packs, arranged.grid, b);
  EXPECT_LT(difference(a.x, b.x, a.count), 1e-6);
  EXPECT_LT(difference(a.vx, b.vx, a.count), 1e-4);
  EXPECT_LT(difference(a.vz, b.vz, a.count), 1e-4);
  EXPECT_LT(difference(a.szz, b.szz, a.count), 1e-5);
  EXPECT_LT(difference(a.sxz, b.sxz, a.count), 1e-4);
}

// Sixteen lanes are one vector with AVX-512 and two with AVX2.
TEST(Packs, GiveTheSameBytesWhateverTheWidthOfTheVectors) {
  constexpr std::int64_t wide = HWY_AVX3 | HWY_AVX3_DL;
  if ((hwy::SupportedTargets() & wide) == 0 || (hwy::SupportedTargets() & HWY_AVX2) == 0) {
    GTEST_SKIP() << "this processor has not both AVX2 and AVX-512";
  }
  const Seeded s = moving_bank();
  const auto moved = [&] {
    Particles p = s.particles;
    auto stage = begin_packed_stage(p, s.grid, s.laws);
    std::mt19937 random(11);
    for (int i = 0; i < 5; ++i) {
      steps(*stage, 3);
      shake(stage->packs, stage->grid, random);
      spread_all(*stage);  // strays of both halves of a pack
      steps(*stage, 2);
      EXPECT_TRUE(tidy_up(*stage));
    }
    steps(*stage, 3);
    unpack(stage->packs, stage->grid, p);
    return p;
  };
  Particles a = moved();
  hwy::DisableTargets(wide);
  Particles b = moved();
  hwy::DisableTargets(0);
  const auto all_a = a.arrays(), all_b = b.arrays();
  for (std::size_t i = 0; i < all_a.size(); ++i) EXPECT_EQ(*all_a[i], *all_b[i]);
}

TEST(Packs, ConserveMassAndMomentum) {
  const Seeded s = moving_bank();
  auto stage = begin_packed_stage(s.particles, s.grid, s.laws);
  steps(*stage, 4);
  const Balances balances = transfer_balance(*stage);
  EXPECT_LT(balances.mass, 1e-6);  // single precision
  EXPECT_LT(balances.momentum, 1e-6);
}

// Steps of 1e-9 at a strain of 1: each is lost to single precision, their sum is not.
TEST(Packs, DoNotLoseCreep) {
  Seeded s = moving_bank();
  Particles& p = s.particles;
  for (auto* array : {&p.vx, &p.vz}) std::fill(array->begin(), array->end(), 0.0);
  auto stage = begin_packed_stage(p, s.grid, s.laws);
  for (Pack& pack : stage->packs.pack) {
    std::fill(std::begin(pack.plastic_strain), std::end(pack.plastic_strain), Real{1});
    std::fill(std::begin(pack.plastic_rest), std::end(pack.plastic_rest), Real{-4e-8F});
  }
  // The remolded clay yields under its own weight; each lane that does takes up its rest.
  steps(*stage, 1);
  std::size_t grown = 0;
  for (const Pack& pack : stage->packs.pack) {
    for (std::size_t l = 0; l < Pack::lanes; ++l) {
      const double sum =
          static_cast<double>(pack.plastic_strain[l]) - static_cast<double>(pack.plastic_rest[l]);
      if (pack.particle[l] >= 0 && sum > 1 + 4e-8 - 1e-12) ++grown;
    }
  }
  EXPECT_EQ(grown, stage->packs.count);
}

TEST(Packs, AnyNumberOfThreadsGivesTheSameBytes) {
  RunSettings settings = coarse();
  settings.stop.max_time_s = 4;
  Frame one, many;
  Listener listener;
  listener.frame = [&](const Frame& f) { one = f; };
  const SectionResult a = simulate(bank(10, 30, 25e3), settings, listener);
  for (const int threads : {2, 3, 8}) {
    listener.frame = [&](const Frame& f) { many = f; };
    const SectionResult b = simulate(bank(10, 30, 25e3), settings, listener, threads);
    EXPECT_EQ(a.steps, b.steps);
    EXPECT_EQ(a.balances.energy, b.balances.energy);
    EXPECT_EQ(one.x, many.x);
    EXPECT_EQ(one.velocity_z, many.velocity_z);
    EXPECT_EQ(one.stress_xz, many.stress_xz);
    EXPECT_EQ(one.plastic_strain, many.plastic_strain);
  }
}

TEST(Packs, ALostPointIsSaid) {
  Seeded s = moving_bank();
  s.particles.x[0] = -10;
  EXPECT_FALSE(begin_packed_stage(s.particles, s.grid, s.laws));
  s.particles.x[0] = std::nan("");
  EXPECT_FALSE(begin_packed_stage(s.particles, s.grid, s.laws));
}

TEST(Packs, LeaveRateFlowAndAveragingToTheReference) {
  Section section = bank(10, 30, 25e3);
  const Seeded plain = seed_particles(section, {});
  EXPECT_TRUE(packs_can_run(plain.grid, plain.laws));
  section.materials["clay"].poisson_ratio = 0.49;
  const Seeded averaged = seed_particles(section, {});
  EXPECT_FALSE(packs_can_run(averaged.grid, averaged.laws));
  section.materials["clay"].poisson_ratio = 0.45;
  section.materials["clay"].rate = SemiLogarithmicRate{};
  const Seeded viscous = seed_particles(section, {});
  EXPECT_FALSE(packs_can_run(viscous.grid, viscous.laws));
}

// Within one cell.
TEST(Packs, RetrogressionIsThatOfTheReference) {
  Section section = bank(10, 30, 27e3);
  RunSettings settings = coarse();
  settings.trigger = UndrainedTrigger{4.0};
  const SectionResult packed = simulate(section, settings);
  settings.precision = Precision::double_precision;
  const SectionResult reference = simulate(section, settings);
  EXPECT_NEAR(packed.crest_to_crest_retrogression_m, reference.crest_to_crest_retrogression_m,
              settings.resolution.cell_m);
  EXPECT_NEAR(packed.runout_m, reference.runout_m, settings.resolution.cell_m);
}

}  // namespace
}  // namespace leda::solver::test
