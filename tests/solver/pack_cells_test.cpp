// Packs and the cells of their points: every point once, at home or on its way there.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <random>

#include "solver/kernel/rehome.hpp"
#include "solver/run/observe.hpp"
#include "tests/solver/moving_bank.hpp"

namespace leda::solver::test {
namespace {

template <class Real>
struct PackedBank {
  Seeded seeded = moving_bank();
  Grid<Real> grid = make_grid<Real>(seeded.size);
  Packs<Real> packs;

  PackedBank() { EXPECT_TRUE(pack(seeded.particles, grid, packs)); }
  Particles particles() const { return unpack(packs, seeded.size.h); }
};

template <class Real>
class PackCells : public ::testing::Test {};
TYPED_TEST_SUITE(PackCells, BothPrecisions, PrecisionNames);

// What holds of packs at any time: every point once, at home or known as a stray, in a column of
// its group; nothing in the reserve; rows in use up to what every point sees.
template <class Real>
void expect_sound(const Packs<Real>& packs, const Grid<Real>& grid) {
  std::vector<int> times(packs.count, 0);
  for (std::size_t g = 0; g < packs.group.size(); ++g) {
    const PackGroup& group = packs.group[g];
    std::size_t points = 0;
    for (std::size_t i = group.first; i < group.first + group.room; ++i) {
      const Pack<Real>& p = packs.pack[i];
      for (std::size_t l = 0; l < Pack<Real>::lanes; ++l) {
        const bool has = p.id[l] >= 0;
        EXPECT_EQ((packs.taken[i] >> l & 1) != 0, has);
        if (!has) {
          EXPECT_EQ(p.mass[l], 0);
          EXPECT_EQ(p.volume[l], 0);
          continue;
        }
        ++points;
        ++times[static_cast<std::size_t>(p.id[l])];
        EXPECT_LT(i, group.end());
        EXPECT_EQ(packs.place[i].column / columns_of_a_group, g);
        EXPECT_LE(packs.place[i].row + l % Pack<Real>::rows + 4,
                  grid.top[packs.place[i].column + 2]);
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

TYPED_TEST(PackCells, HoldEveryParticleOnceInItsCell) {
  const PackedBank<TypeParam> b;
  expect_sound(b.packs, b.grid);
  const Particles p = b.particles();
  for (const auto& number : point_numbers<double>) {
    if (number.value == nullptr) continue;
    EXPECT_LT(difference(p, b.seeded.particles, number.value), within<TypeParam>(1e-7, 1e-15))
        << number.name;
  }
  for (const auto& number : motion_numbers<double>) {
    EXPECT_LT(difference(p, b.seeded.particles, number.value), within<TypeParam>(1e-7, 1e-15))
        << number.name;
  }
}

TYPED_TEST(PackCells, StraysFindTheirNewCellsAndTakeAllTheyHoldAlong) {
  PackedBank<TypeParam> b;
  std::mt19937 random(3);
  const std::size_t room = b.packs.pack.size();
  for (int i = 0; i < 40; ++i) {
    shake(b.packs, b.grid, random);
    const Particles before = b.particles();
    ASSERT_TRUE(rehome_strays(b.packs, b.grid));
    EXPECT_TRUE(std::ranges::all_of(b.packs.strayed, [](LaneBits bits) { return bits == 0; }));
    expect_sound(b.packs, b.grid);
    const Particles after = b.particles();
    EXPECT_LT(difference(after, before, &Particle::x), 1e-6);
    EXPECT_LT(difference(after, before, &Particle::z), 1e-6);
    for (const auto number : {&Particle::szz, &Particle::plastic_strain, &Particle::vx,
                              &Particle::czz, &Particle::volume}) {
      EXPECT_EQ(difference(after, before, number), 0);
    }
  }
  // Scattered points need more packs than a lattice does; the reserve alone would not have held
  // them.
  EXPECT_GT(b.packs.pack.size(), room);
}

// The highest point of every column, strays included, found without going through all of them.
TYPED_TEST(PackCells, ShowTheSurfaceOfTheirPoints) {
  Seeded seeded = moving_bank();
  AnyModel any = model_of<TypeParam>(seeded);
  auto& model = std::get<Model<TypeParam>>(any);
  std::mt19937 random(5);
  for (int i = 0; i < 10; ++i) {
    if (i % 2 == 0) {
      shake(model.packs, model.grid, random);
    } else {
      ASSERT_TRUE(tidy_up(model));
    }
    Surface expected = empty_surface(seeded);
    for (const Particle& p : particles_of(model)) {
      double& top = expected.z[column_of(expected, p.x + seeded.origin_x)];
      top = std::max(top, p.z + seeded.origin_z + 0.5 * seeded.spacing);
    }
    EXPECT_EQ(surface(any, seeded).z, expected.z);
  }
}

TYPED_TEST(PackCells, StayAsTheyAreWherePointsLeaveTheGrid) {
  PackedBank<TypeParam> b;
  std::mt19937 random(3);
  shake(b.packs, b.grid, random);
  for (const TypeParam far :
       {TypeParam{-1e6}, TypeParam{1e6}, std::numeric_limits<TypeParam>::quiet_NaN()}) {
    Packs<TypeParam> left = b.packs;
    const auto last = static_cast<std::size_t>(left.group.back().first);
    const std::size_t i = left.group.back().in_use > 0 ? last : 0;
    const auto lane = static_cast<std::size_t>(std::countr_zero(left.taken[i]));
    left.pack[i].x[lane] = far;
    left.strayed[i] = static_cast<LaneBits>(left.strayed[i] | 1U << lane);
    Grid<TypeParam> same = b.grid;
    EXPECT_FALSE(rehome_strays(left, same));
    EXPECT_EQ(left.taken, b.packs.taken);
    EXPECT_EQ(same.top, b.grid.top);
  }
}

TYPED_TEST(PackCells, ALostParticleIsSaid) {
  for (const double x : {-10.0, 1e6, std::nan("")}) {
    Seeded s = moving_bank();
    s.particles[3].x = x;
    EXPECT_FALSE(make_model<TypeParam>(s.particles, s.size, s.laws)) << x;
  }
}

}  // namespace
}  // namespace leda::solver::test
