#include "solver/kernel/step.hpp"

namespace leda::solver {

StepSums step(Particles& particles, Grid& grid, const LawTable& laws,
              const StepSettings& settings) {
  StepSums sums;
  clear(grid);
  particles_to_grid(particles, grid);
  sums.grid = update_velocity(grid, {settings.dt, settings.gravity, settings.damping});
  sums.particles = grid_to_particles(particles, grid, laws, settings.dt, settings.move);
  return sums;
}

}  // namespace leda::solver
