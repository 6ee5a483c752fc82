#pragma once
// A rectangular block of particles of one elastic or Tresca material, for tests of the step.

#include <cmath>
#include <functional>
#include <limits>

#include "solver/kernel/sort_particles.hpp"
#include "solver/kernel/step.hpp"

namespace leda::solver::test {

struct BlockMaterial {
  double youngs_modulus = 1e6, poisson_ratio = 0.3, density = 1000;
  double peak = 1e30;  ///< s_up, Pa
};

inline LawTable one_law(const BlockMaterial& m) {
  const double endless = std::numeric_limits<double>::infinity();
  LawTable t;
  t.bulk = {m.youngs_modulus / (3 * (1 - 2 * m.poisson_ratio))};
  t.shear = {m.youngs_modulus / (2 * (1 + m.poisson_ratio))};
  t.peak = t.floor = {m.peak};
  t.amplitude = t.rate = t.line_start = t.line_slope = t.last = {0.0};
  t.exp_end = t.line_end = {endless};
  t.softens = t.material = {0};
  t.stiffest_speed = std::sqrt((t.bulk[0] + 4.0 / 3.0 * t.shear[0]) / m.density);
  return t;
}

/// Particles per_side x per_side a cell over [x0, x0 + length] x [z0, z0 + height].
struct Block {
  Particles particles;
  Grid grid;
  LawTable laws;

  Block(double h, double model_length, double model_height, double x0, double z0, double length,
        double height, const BlockMaterial& material, int per_side = 2)
      : grid(make_grid(h, model_length, model_height)), laws(one_law(material)) {
    const double spacing = h / per_side;
    const auto columns = std::lround(length / spacing), rows = std::lround(height / spacing);
    for (long i = 0; i < columns; ++i) {
      for (long j = 0; j < rows; ++j) {
        particles.x.push_back(x0 + (static_cast<double>(i) + 0.5) * spacing);
        particles.z.push_back(z0 + (static_cast<double>(j) + 0.5) * spacing);
      }
    }
    const std::size_t n = particles.x.size();
    particles.start_x = particles.x;
    particles.start_z = particles.z;
    particles.mass.assign(n, material.density * spacing * spacing);
    particles.volume.assign(n, spacing * spacing);
    particles.resize(n);
    for (std::size_t i = 0; i < n; ++i) particles.id[i] = static_cast<std::int32_t>(i);
    particles.fill_padding();
    sort_particles(particles, grid);
  }

  double time_step(double factor = 0.4) const { return factor * grid.h / laws.stiffest_speed; }

  void run(
      int steps, const StepSettings& settings, const std::function<void(int)>& look = [](int) {}) {
    for (int i = 0; i < steps; ++i) {
      if (i % 10 == 0) sort_particles(particles, grid);
      step(particles, grid, laws, settings);
      look(i + 1);
    }
  }

  /// Imposes a uniform velocity gradient for one step, past the momentum balance.
  void strain(double lxx, double lxz, double lzx, double lzz, double dt) {
    for (std::size_t i = 0; i < grid.columns; ++i) {
      for (std::size_t k = 0; k < grid.rows; ++k) {
        const double x = (static_cast<double>(i) - 1) * grid.h;
        const double z = (static_cast<double>(k) - 1) * grid.h;
        grid.velocity[grid.index(i, k) * 2] = lxx * x + lxz * z;
        grid.velocity[grid.index(i, k) * 2 + 1] = lzx * x + lzz * z;
      }
    }
    grid_to_particles(particles, grid, laws, dt, false);
  }
};

}  // namespace leda::solver::test
