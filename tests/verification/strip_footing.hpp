#pragma once
// A rigid rough strip pushed into weightless clay: the indentation pressure over s_u.

#include <cmath>

#include "tests/solver/block.hpp"

namespace leda::solver::test {

struct Footing {
  int cells = 8;  ///< under half the strip
  double poisson_ratio = 0.45;
  double settlement = 0.08;  ///< of the strip's half width
};

/// Half the strip by symmetry (a side without friction), width 2 m, s_u = 1000 Pa; 4 m of clay to
/// the side and 2.5 m below. Positions are held, so the answer is that of small strain. The nodes
/// on and above the surface under the strip move down at a constant speed; what they carry is the
/// sum of their internal forces. Between the last node of the strip and its free neighbour the
/// velocity falls from one to nothing, so the strip ends half a cell beyond that node.
inline double bearing_capacity_factor(const Footing& f) {
  const double strength = 1000, half_width = 1, depth = 2.5, width = 5;
  const double h = half_width / (f.cells + 0.5);
  const double top = h * std::ceil(depth / h), length = h * std::ceil(width / h);
  const double shear = 200 * strength;
  Block b(h, length, top + 4 * h, 0, 0, length, top,
          {2 * shear * (1 + f.poisson_ratio), f.poisson_ratio, 1000, strength});
  if (nearly_incompressible(b.laws)) average_spans(b.grid);
  const auto surface_row = static_cast<std::size_t>(std::lround(top / h)) + 1;
  const auto last_column = static_cast<std::size_t>(f.cells) + 1;
  // Slow against the shear wave: what the ground's inertia adds falls with the speed (README.md).
  const double dt = b.time_step(), speed = 1.65e-4 * std::sqrt(shear / 1000);
  const int steps = static_cast<int>(f.settlement * half_width / speed / dt);
  double largest = 0, recent = 0;
  sort_particles(b.particles, b.grid);
  for (int k = 0; k < steps; ++k) {
    clear(b.grid);
    particles_to_grid(b.particles, b.grid);
    update_velocity(b.grid, {dt, 0.0, 0.5});
    double force = 0;
    for (std::size_t i = 1; i <= last_column; ++i) {
      for (std::size_t row = surface_row; row < b.grid.top[i]; ++row) {
        force += b.grid.at(i, row)[4];
        b.grid.velocity[b.grid.index(i, row) * 2] = 0;
        b.grid.velocity[b.grid.index(i, row) * 2 + 1] = -speed;
      }
    }
    for (std::size_t row = surface_row; row < b.grid.top[0]; ++row) {  // images of the symmetry
      b.grid.velocity[b.grid.index(0, row) * 2] = 0;
      b.grid.velocity[b.grid.index(0, row) * 2 + 1] = -speed;
    }
    grid_to_particles(b.particles, b.grid, b.laws, dt, false);
    recent += 0.01 * (force - recent);  // waves pass: a mean over about 100 steps
    largest = std::max(largest, recent);
  }
  return largest / half_width / strength;
}

}  // namespace leda::solver::test
