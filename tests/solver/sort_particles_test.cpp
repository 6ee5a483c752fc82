#include "solver/kernel/sort_particles.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/solver/block.hpp"

namespace leda::solver::test {
namespace {

TEST(SortParticles, CellsNeverGoBack) {
  Block b(1, 10, 10, 2, 2, 5, 5, {});
  for (std::size_t i = 0; i < b.particles.count; ++i) {
    b.particles.x[i] = 9 - b.particles.x[i];
  }
  ASSERT_TRUE(sort_particles(b.particles, b.grid));
  double last = -1;
  for (std::size_t i = 0; i < b.particles.count; ++i) {
    const double cell =
        std::floor(b.particles.x[i] + 0.5) * 100 + std::floor(b.particles.z[i] + 0.5);
    EXPECT_GE(cell, last);
    last = cell;
  }
}

TEST(SortParticles, NeverSetsAParticleBesideTheRowsInUse) {
  Block b(1, 10, 10, 2, 2, 5, 5, {});
  for (std::size_t i = 0; i < b.particles.count; ++i) {
    const auto row = static_cast<std::size_t>(std::floor(b.particles.z[i] + 0.5));
    const auto column = static_cast<std::size_t>(std::floor(b.particles.x[i] + 0.5));
    for (std::size_t c = column; c < column + 3; ++c) EXPECT_GE(b.grid.top[c], row + 3);
  }
}

TEST(SortParticles, SaysWhenAParticleHasLeft) {
  for (const double x : {-2.0, 11.5, std::numeric_limits<double>::quiet_NaN()}) {
    Block b(1, 10, 10, 2, 2, 5, 5, {});
    b.particles.x[3] = x;
    EXPECT_FALSE(sort_particles(b.particles, b.grid)) << x;
  }
}

}  // namespace
}  // namespace leda::solver::test
