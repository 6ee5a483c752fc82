#include "solver/run/trigger.hpp"

#include <algorithm>
#include <cmath>

namespace leda::solver {

std::size_t excavate(RunState& run, const Polyline& polygon) {
  Particles particles = particles_of(run.model);
  const std::size_t removed = std::erase_if(particles, [&](const Particle& p) {
    return is_inside(polygon, {p.x + run.seeded.origin_x, p.z + run.seeded.origin_z});
  });
  if (removed > 0) take_particles(run, particles);
  return removed;
}

Polyline toe_cut(const Section& section, const CrestAndToe& bank, double height) {
  const double way = bank.crest.x - bank.toe.x;
  const int pieces = 2000;
  double face = bank.crest.x;
  for (int i = 1; i <= pieces; ++i) {
    const double x = bank.toe.x + way * i / pieces;
    if (elevation_at(section.ground, x) - bank.toe.z >= height) {
      face = x;
      break;
    }
  }
  const double top = std::max(bank.crest.z, bank.toe.z + height) + 1;
  return {{bank.toe.x, bank.toe.z}, {face, bank.toe.z}, {face, top}, {bank.toe.x, top}};
}

}  // namespace leda::solver
