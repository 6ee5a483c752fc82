#pragma once
// A bank in motion, for tests of the kernel.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "solver/kernel/model.hpp"
#include "solver/kernel/pack_particles.hpp"
#include "solver/run/seed_particles.hpp"
#include "tests/solver/bank.hpp"
#include "tests/solver/precisions.hpp"

namespace leda::solver::test {

/// Gives the particles a motion of their own, so that strain, spin and yield are all there.
inline void set_in_motion(Seeded& s) {
  for (std::size_t i = 0; i < s.particles.size(); ++i) {
    Particle& p = s.particles[i];
    p.vx = 0.5 * std::sin(0.2 * p.x) * p.z / 13;
    p.vz = -0.3 * std::cos(0.15 * p.x) * p.z / 13;
    p.plastic_strain = i % 3 == 0 ? 0.05 : 0.0;
  }
}

inline Seeded moving_bank(std::uint64_t seed = 1) {
  Resolution resolution;
  resolution.seed = seed;
  Seeded s = seed_particles(bank(10, 30, 25e3), resolution);
  set_in_motion(s);
  return s;
}

template <class Real>
Model<Real> model_of(const Seeded& s, const ModelSettings& settings = {}) {
  auto model = make_model<Real>(s.particles, s.size, s.laws, settings);
  EXPECT_TRUE(model);
  return std::move(*model);
}

template <class Real>
Particles particles_of(const Model<Real>& model) {
  return unpack(model.packs, model.grid.h);
}

/// Steps; the last keeps the motion.
template <class Real>
StepSums take_steps(Model<Real>& model, int count, int threads = 1, double dt = 1e-3) {
  StepSums sums;
  ThreadTeam team(threads);
  for (int i = 1; i <= count; ++i) {
    sums = step(model, {dt, gravity, 0.02, true}, i == count, team);
    EXPECT_FALSE(sums.points.left_grid);
  }
  return sums;
}

/// Largest difference of a number over its largest value.
inline double difference(const Particles& a, const Particles& b, double Particle::*number) {
  EXPECT_EQ(a.size(), b.size());
  double most = 0, size = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    most = std::max(most, std::abs(a[i].*number - b[i].*number));
    size = std::max(size, std::abs(b[i].*number));
  }
  return size > 0 ? most / size : most;
}

/// Expects the same bytes in every number.
inline void expect_same_bytes(const Particles& a, const Particles& b) {
  ASSERT_EQ(a.size(), b.size());
  for (const auto& number : point_numbers<double>) {
    if (number.value == nullptr) continue;
    for (std::size_t i = 0; i < a.size(); ++i) {
      ASSERT_EQ(a[i].*number.value, b[i].*number.value) << number.name << " of " << i;
    }
  }
  for (const auto& number : motion_numbers<double>) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      ASSERT_EQ(a[i].*number.value, b[i].*number.value) << number.name << " of " << i;
    }
  }
}

/// Moves points about, away from the model's edges, and tells which have strayed.
template <class Real>
void shake(Packs<Real>& packs, const Grid<Real>& grid, std::mt19937& random) {
  std::uniform_real_distribution<float> shift(-0.4F, 0.4F);
  for_each_point(packs, [&](std::size_t i, std::size_t l) {
    const std::size_t column = packs.place[i].column,
                      row = packs.place[i].row + l % Pack<Real>::rows;
    if (column <= 4 || column + 8 >= grid.columns || row <= 2 || row + 8 >= grid.rows) return;
    Pack<Real>& p = packs.pack[i];
    p.x[l] += static_cast<Real>(shift(random));
    p.z[l] += static_cast<Real>(shift(random));
    const bool strays = std::floor(p.x[l]) != 0 || std::floor(p.z[l]) != 0;
    if (strays) packs.strayed[i] = static_cast<LaneBits>(packs.strayed[i] | 1U << l);
  });
}

}  // namespace leda::solver::test
