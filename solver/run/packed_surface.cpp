#include "solver/run/packed_surface.hpp"

#include <algorithm>

namespace leda::solver {

namespace {

struct Origin {
  double x, z;  // of the packs, m
  double half;  // of a particle's size, m
};

void raise(Surface& s, const Packs& packs, std::size_t i, double h, const Origin& origin) {
  const Pack& p = packs.pack[i];
  const double column = packs.place[i].column - 0.5, row = packs.place[i].row - 0.5;
  for (std::size_t l = 0; l < Pack::lanes; ++l) {
    if (p.particle[l] < 0) continue;
    const double x = (column + static_cast<double>(p.x[l])) * h;
    const double z = (row + static_cast<double>(l % Pack::rows) + static_cast<double>(p.z[l])) * h;
    double& top = s.z[column_of(s, x + origin.x)];
    top = std::max(top, z + origin.z + origin.half);
  }
}

// Whether no point of the pack can reach above what is known already. Half of home cell c lies in
// column c - 1 of the surface, half in column c.
bool is_below(const Surface& s, const Packs& packs, std::size_t i, double h, const Origin& origin) {
  if (packs.strayed[i] != 0) return false;
  const PackPlace& place = packs.place[i];
  if (place.column == 0 || place.column >= s.z.size()) return false;
  const double highest =
      (place.row + static_cast<double>(Pack::rows) - 0.5) * h + origin.z + origin.half;
  return highest <= s.z[place.column - 1] && highest <= s.z[place.column];
}

}  // namespace

Surface packed_surface(const Packs& packs, const PackGrid& grid, const Seeded& seeded) {
  Surface s = empty_surface(seeded);
  const Origin origin{seeded.origin_x, seeded.origin_z, 0.5 * seeded.spacing};
  for (std::size_t i = packs.pack.size(); i-- > 0;) {  // the highest of a column stand last
    if (packs.taken[i] != 0 && !is_below(s, packs, i, grid.h, origin)) {
      raise(s, packs, i, grid.h, origin);
    }
  }
  return s;
}

}  // namespace leda::solver
