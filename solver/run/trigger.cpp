#include "solver/run/trigger.hpp"

#include <algorithm>
#include <cmath>

namespace leda::solver {

std::size_t excavate(RunState& run, const Polyline& polygon) {
  Particles& p = run.seeded.particles;
  std::vector<std::int32_t> kept;
  for (std::size_t i = 0; i < p.count; ++i) {
    const Point at{p.x[i] + run.seeded.origin_x, p.z[i] + run.seeded.origin_z};
    if (!is_inside(polygon, at)) kept.push_back(static_cast<std::int32_t>(i));
  }
  const std::size_t removed = p.count - kept.size();
  if (removed > 0) p.reorder(kept);
  run.since_sort = 0;
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
