#include <algorithm>

#include "solver/run/observe.hpp"

namespace leda::solver {

namespace {

struct Origin {
  double x, z;  // of the points, m
  double half;  // of a particle's size, m
};

template <class Real>
void raise(Surface& s, const Model<Real>& model, std::size_t i, const Origin& origin) {
  const auto& packs = model.packs;
  for (std::size_t l = 0; l < Pack<Real>::lanes; ++l) {
    if ((packs.taken[i] >> l & 1U) == 0) continue;
    const PointAt at = point_at(packs, i, l, model.grid.h);
    double& top = s.z[column_of(s, at.x + origin.x)];
    top = std::max(top, at.z + origin.z + origin.half);
  }
}

// Whether no point of the pack can reach above what is known already. Half of home cell c lies in
// column c - 1 of the surface, half in column c.
template <class Real>
bool is_below(const Surface& s, const Model<Real>& model, std::size_t i, const Origin& origin) {
  if (model.packs.strayed[i] != 0) return false;
  const PackPlace& place = model.packs.place[i];
  if (place.column == 0 || place.column >= s.z.size()) return false;
  const double highest = (place.row + static_cast<double>(Pack<Real>::rows) - 0.5) * model.grid.h +
                         origin.z + origin.half;
  return highest <= s.z[place.column - 1] && highest <= s.z[place.column];
}

}  // namespace

Surface surface(const AnyModel& model, const Seeded& seeded) {
  Surface s = empty_surface(seeded);
  const Origin origin{seeded.origin_x, seeded.origin_z, 0.5 * seeded.spacing};
  with_model(model, [&](const auto& m) {
    for (std::size_t i = m.packs.pack.size(); i-- > 0;) {  // the highest of a column stand last
      if (m.packs.taken[i] != 0 && !is_below(s, m, i, origin)) raise(s, m, i, origin);
    }
  });
  return s;
}

}  // namespace leda::solver
