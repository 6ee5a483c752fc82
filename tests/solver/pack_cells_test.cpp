// Packs and the cells of their points: every point once, at home or on its way there.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <random>

#include "solver/kernel/pack.hpp"
#include "solver/kernel/rehome.hpp"
#include "solver/run/packed_surface.hpp"
#include "tests/solver/moving_bank.hpp"

namespace leda::solver::test {
namespace {

struct PackedBank {
  Seeded seeded;
  PackGrid grid;
  Packs packs;
};

PackedBank packed_bank() {
  PackedBank b{moving_bank(), {}, {}};
  b.grid = make_pack_grid(b.seeded.grid);
  EXPECT_TRUE(pack(b.seeded.particles, b.grid, b.packs));
  return b;
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
  auto [s, grid, packs] = packed_bank();
  expect_sound(packs, grid);
  Particles p = s.particles;
  unpack(packs, grid, p);
  EXPECT_LT(difference(p.x, s.particles.x, p.count), 1e-7);
  EXPECT_LT(difference(p.z, s.particles.z, p.count), 1e-7);
}

TEST(Packs, StraysFindTheirNewCells) {
  auto [s, grid, packs] = packed_bank();
  std::mt19937 random(3);
  Particles before = s.particles, after = s.particles;
  const std::size_t room = packs.pack.size();
  for (int i = 0; i < 40; ++i) {
    shake(packs, grid, random);
    unpack(packs, grid, before);
    ASSERT_TRUE(rehome_strays(packs, grid));
    EXPECT_TRUE(std::all_of(packs.strayed.begin(), packs.strayed.end(),
                            [](LaneBits bits) { return bits == 0; }));
    expect_sound(packs, grid);
    unpack(packs, grid, after);
    EXPECT_LT(difference(after.x, before.x, s.particles.count), 1e-6);
    EXPECT_LT(difference(after.z, before.z, s.particles.count), 1e-6);
  }
  // Scattered points need more packs than a lattice does; the reserve alone would not have held
  // them.
  EXPECT_GT(packs.pack.size(), room);
}

TEST(Packs, ShowTheSurfaceOfTheirPoints) {
  auto [s, grid, packs] = packed_bank();
  std::mt19937 random(5);
  for (int i = 0; i < 10; ++i) {
    shake(packs, grid, random);  // with strays, and then without
    unpack(packs, grid, s.particles);
    EXPECT_EQ(packed_surface(packs, grid, s).z, surface(s).z);
    ASSERT_TRUE(rehome_strays(packs, grid));
    unpack(packs, grid, s.particles);
    EXPECT_EQ(packed_surface(packs, grid, s).z, surface(s).z);
  }
}

TEST(Packs, StayAsTheyAreWherePointsLeaveTheGrid) {
  auto [s, grid, packs] = packed_bank();
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

}  // namespace
}  // namespace leda::solver::test
