// The packed step against the double reference, and what packing keeps.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "hwy/targets.h"
#include "solver/packs/packed_stage.hpp"
#include "solver/packs/packed_surface.hpp"
#include "solver/packs/rehome.hpp"
#include "solver/seed_particles.hpp"
#include "solver/simulate.hpp"
#include "solver/sort_particles.hpp"
#include "tests/solver/bank.hpp"

namespace leda::solver::test {
namespace {

constexpr double dt = 1e-3;

// A bank with a motion of its own, so that strain, spin and yield are all there.
Seeded moving_bank(std::uint64_t seed = 1) {
  Resolution resolution;
  resolution.seed = seed;
  Seeded s = seed_particles(bank(10, 30, 25e3), resolution);
  Particles& p = s.particles;
  for (std::size_t i = 0; i < p.count; ++i) {
    p.vx[i] = 0.5 * std::sin(0.2 * p.x[i]) * p.z[i] / 13;
    p.vz[i] = -0.3 * std::cos(0.15 * p.x[i]) * p.z[i] / 13;
    p.plastic_strain[i] = i % 3 == 0 ? 0.05 : 0.0;
  }
  EXPECT_TRUE(sort_particles(s.particles, s.grid));
  return s;
}

// Largest difference of an array over its largest value.
double difference(const std::vector<double>& a, const std::vector<double>& b, std::size_t count) {
  double most = 0, size = 0;
  for (std::size_t i = 0; i < count; ++i) {
    most = std::max(most, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(b[i]));
  }
  return most / size;
}

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

// What holds of packs at any time: every point once, at home or known as a stray, in a column of
// its group; nothing in the reserve; rows in use up to what every point sees.
void expect_sound(const Packs& packs, const PackGrid& grid) {
  std::vector<int> times(packs.count, 0);
  for (std::size_t g = 0; g < packs.group.size(); ++g) {
    const PackGroup& group = packs.group[g];
    std::size_t points = 0;
    for (std::size_t i = group.first; i < group.first + group.room; ++i) {
      const Pack& p = packs.pack[i];
      for (std::size_t l = 0; l < Pack::lanes; ++l) {
        const bool has = p.particle[l] >= 0;
        EXPECT_EQ((packs.taken[i] >> l & 1) != 0, has);
        if (!has) {
          EXPECT_EQ(p.mass[l], 0);
          EXPECT_EQ(p.volume[l], 0);
          continue;
        }
        ++points;
        ++times[static_cast<std::size_t>(p.particle[l])];
        EXPECT_LT(i, group.end());
        EXPECT_EQ(packs.place[i].column / columns_of_a_group, g);
        EXPECT_LE(packs.place[i].row + l % Pack::rows + 4, grid.top[packs.place[i].column + 2]);
        if ((packs.strayed[i] >> l & 1) != 0) continue;
        EXPECT_GE(p.x[l], 0);
        EXPECT_LT(p.x[l], 1);
        EXPECT_GE(p.z[l], 0);
        EXPECT_LT(p.z[l], 1);
      }
    }
    EXPECT_EQ(points, group.points);
  }
  EXPECT_EQ(std::count(times.begin(), times.end(), 1), static_cast<std::ptrdiff_t>(times.size()));
}

TEST(Packs, HoldEveryParticleOnceInItsCell) {
  const Seeded s = moving_bank();
  PackGrid grid = make_pack_grid(s.grid);
  Packs packs;
  ASSERT_TRUE(pack(s.particles, grid, packs));
  expect_sound(packs, grid);
  Particles p = s.particles;
  unpack_positions(packs, grid, p);
  EXPECT_LT(difference(p.x, s.particles.x, p.count), 1e-7);
  EXPECT_LT(difference(p.z, s.particles.z, p.count), 1e-7);
}

// Moves points about, away from the model's edges, and tells which have strayed.
void shake(Packs& packs, const PackGrid& grid, std::mt19937& random) {
  std::uniform_real_distribution<float> shift(-0.4F, 0.4F);
  for (std::size_t i = 0; i < packs.pack.size(); ++i) {
    Pack& p = packs.pack[i];
    for (std::size_t l = 0; l < Pack::lanes; ++l) {
      const std::size_t column = packs.place[i].column, row = packs.place[i].row + l % Pack::rows;
      const bool inside = column > 4 && column + 8 < grid.columns && row > 2 && row + 8 < grid.rows;
      if (!inside || p.particle[l] < 0) continue;
      p.x[l] += shift(random);
      p.z[l] += shift(random);
      const bool strays = std::floor(p.x[l]) != 0 || std::floor(p.z[l]) != 0;
      if (strays) packs.strayed[i] = static_cast<LaneBits>(packs.strayed[i] | 1U << l);
    }
  }
}

TEST(Packs, StraysFindTheirNewCells) {
  const Seeded s = moving_bank();
  PackGrid grid = make_pack_grid(s.grid);
  Packs packs;
  ASSERT_TRUE(pack(s.particles, grid, packs));
  std::mt19937 random(3);
  Particles before = s.particles, after = s.particles;
  const std::size_t room = packs.pack.size();
  for (int i = 0; i < 40; ++i) {
    shake(packs, grid, random);
    unpack_positions(packs, grid, before);
    ASSERT_TRUE(rehome_strays(packs, grid));
    EXPECT_TRUE(std::all_of(packs.strayed.begin(), packs.strayed.end(),
                            [](LaneBits bits) { return bits == 0; }));
    expect_sound(packs, grid);
    unpack_positions(packs, grid, after);
    EXPECT_LT(difference(after.x, before.x, s.particles.count), 1e-6);
    EXPECT_LT(difference(after.z, before.z, s.particles.count), 1e-6);
  }
  // Scattered points need more packs than a lattice does; the reserve alone would not have held
  // them.
  EXPECT_GT(packs.pack.size(), room);
}

TEST(Packs, ShowTheSurfaceOfTheirPoints) {
  Seeded s = moving_bank();
  PackGrid grid = make_pack_grid(s.grid);
  Packs packs;
  ASSERT_TRUE(pack(s.particles, grid, packs));
  std::mt19937 random(5);
  for (int i = 0; i < 10; ++i) {
    shake(packs, grid, random);  // with strays, and then without
    unpack_positions(packs, grid, s.particles);
    EXPECT_EQ(packed_surface(packs, grid, s).z, surface(s).z);
    ASSERT_TRUE(rehome_strays(packs, grid));
    unpack_positions(packs, grid, s.particles);
    EXPECT_EQ(packed_surface(packs, grid, s).z, surface(s).z);
  }
}

TEST(Packs, StayAsTheyAreWherePointsLeaveTheGrid) {
  const Seeded s = moving_bank();
  PackGrid grid = make_pack_grid(s.grid);
  Packs packs;
  ASSERT_TRUE(pack(s.particles, grid, packs));
  std::mt19937 random(3);
  shake(packs, grid, random);
  for (const Real far : {Real{-1e6}, Real{1e6}, std::numeric_limits<Real>::quiet_NaN()}) {
    Packs left = packs;
    const auto last = static_cast<std::size_t>(left.group.back().first);
    const std::size_t i = left.group.back().in_use > 0 ? last : 0;
    const auto lane = static_cast<std::size_t>(std::countr_zero(left.taken[i]));
    left.pack[i].x[lane] = far;
    left.strayed[i] = static_cast<LaneBits>(left.strayed[i] | 1U << lane);
    PackGrid same = grid;
    EXPECT_FALSE(rehome_strays(left, same));
    EXPECT_EQ(left.taken, packs.taken);
    EXPECT_EQ(same.top, grid.top);
  }
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
  settings.full = true;
  const SectionResult reference = simulate(section, settings);
  EXPECT_NEAR(packed.crest_to_crest_retrogression_m, reference.crest_to_crest_retrogression_m,
              settings.resolution.cell_m);
  EXPECT_NEAR(packed.runout_m, reference.runout_m, settings.resolution.cell_m);
}

}  // namespace
}  // namespace leda::solver::test
