#include "solver/run/trigger.hpp"

#include <vector>

namespace leda::solver {

std::size_t excavate(RunState& run, const Polyline& polygon) {
  Particles particles = particles_of(run.model);
  const std::size_t removed = std::erase_if(particles, [&](const Particle& p) {
    return is_inside(polygon, {p.x + run.seeded.origin_x, p.z + run.seeded.origin_z});
  });
  if (removed > 0) take_particles(run, particles);
  return removed;
}

}  // namespace leda::solver
