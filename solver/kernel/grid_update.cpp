#include "solver/kernel/grid_update.hpp"

#include <cmath>

#include "solver/kernel/boundary.hpp"

namespace leda::solver {

namespace {

constexpr double least_mass = 1e-14;  // of a node full of water: below it there is only round-off

void add_gravity(Grid& grid, const GridStep& step, GridSums& sums) {
  for (std::size_t i = 0; i < grid.columns; ++i) {
    double* node = grid.at(i, 0);
    for (std::size_t k = 0; k < grid.top[i]; ++k, node += Grid::width) {
      const double weight = node[0] * step.gravity;
      node[4] -= weight;
      sums.weight += weight;
    }
  }
}

// One axis of one node: returns the new velocity.
double accelerate(double mass, double momentum, double force, const GridStep& step,
                  GridSums& sums) {
  const double before = momentum / mass;
  const double damp = -step.damping * std::abs(force) *
                      (before > 0   ? 1.0
                       : before < 0 ? -1.0
                                    : 0.0);
  const double after = before + (force + damp) * step.dt / mass;
  sums.kinetic_before += 0.5 * mass * before * before;
  sums.kinetic_after += 0.5 * mass * after * after;
  sums.damping_work += damp * 0.5 * (before + after) * step.dt;
  sums.unbalanced_force += std::abs(force);
  return after;
}

}  // namespace

GridSums update_velocity(Grid& grid, const GridStep& step) {
  GridSums sums;
  add_gravity(grid, step, sums);
  fold_images(grid);
  const double least = least_mass * 1000 * grid.h * grid.h;
  for (std::size_t i = 1; i + 1 < grid.columns; ++i) {
    const double* node = grid.at(i, 1);
    double* velocity = &grid.velocity[grid.index(i, 1) * 2];
    for (std::size_t k = 1; k < grid.top[i]; ++k, node += Grid::width, velocity += 2) {
      if (node[0] <= least) {
        velocity[0] = velocity[1] = 0;
        continue;
      }
      velocity[0] = accelerate(node[0], node[1], node[3], step, sums);
      velocity[1] = accelerate(node[0], node[2], node[4], step, sums);
    }
  }
  mirror_velocity(grid);
  return sums;
}

}  // namespace leda::solver
