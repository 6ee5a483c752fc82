#include "solver/kernel/pack_grid.hpp"

namespace leda::solver {

PackGrid make_pack_grid(const Grid& grid, bool keeps_mass) {
  PackGrid g;
  g.h = grid.h;
  g.columns = grid.columns;
  g.rows = grid.rows;
  // A pack that begins in the last row reads and adds up to eight rows and two nodes beyond.
  // An odd number of eights, so that the 45 places a pack adds to do not share the low bits of
  // their addresses: with a stride of 128 a step of Lemieux takes a fifth longer than with 104.
  g.stride = (PackGrid::lead + grid.rows + Pack::rows + 2 + 7) / 8 * 8;
  if (g.stride % 16 == 0) g.stride += 8;
  g.sums.assign(g.columns * PackGrid::values * PackGrid::planes * g.stride, Real{0});
  g.velocity.assign(g.columns * 2 * g.stride, Real{0});
  if (keeps_mass) g.mass.assign(g.columns * g.stride, Real{0});
  g.top.assign(g.columns, 0);
  return g;
}

}  // namespace leda::solver
