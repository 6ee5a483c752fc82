#pragma once
// A bank in motion, for tests of packs.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "solver/kernel/pack_grid.hpp"
#include "solver/kernel/packs.hpp"
#include "solver/kernel/sort_particles.hpp"
#include "solver/run/seed_particles.hpp"
#include "tests/solver/bank.hpp"

namespace leda::solver::test {

// A bank with a motion of its own, so that strain, spin and yield are all there.
inline Seeded moving_bank(std::uint64_t seed = 1) {
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
inline double difference(const std::vector<double>& a, const std::vector<double>& b,
                         std::size_t count) {
  double most = 0, size = 0;
  for (std::size_t i = 0; i < count; ++i) {
    most = std::max(most, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(b[i]));
  }
  return most / size;
}

// Moves points about, away from the model's edges, and tells which have strayed.
inline void shake(Packs& packs, const PackGrid& grid, std::mt19937& random) {
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

}  // namespace leda::solver::test
