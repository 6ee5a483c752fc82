#include "solver/kernel/grid.hpp"

#include <cmath>

namespace leda::solver {

GridSize grid_over(double h, double length, double height) {
  const auto cells = [h](double size) {
    return static_cast<std::size_t>(std::ceil(size / h - 1e-9));
  };
  return {h, cells(length) + 3, cells(height) + 3};
}

template <class Real>
Grid<Real> make_grid(const GridSize& size, const GridExtras& extras) {
  Grid<Real> g;
  g.h = size.h;
  g.columns = size.columns;
  g.rows = size.rows;
  // A pack that begins in the last row reads and adds up to eight rows and two nodes beyond.
  // An odd number of eights, so that the 45 places a pack adds to do not share the low bits of
  // their addresses: with a stride of 128 a step of Lemieux takes a fifth longer than with 104.
  g.stride = (Grid<Real>::lead + size.rows + Pack<Real>::rows + 2 + 7) / 8 * 8;
  if (g.stride % 16 == 0) g.stride += 8;
  g.sums.assign(g.columns * Grid<Real>::values * Grid<Real>::planes * g.stride, Real{0});
  g.velocity.assign(g.columns * 2 * g.stride, Real{0});
  if (extras.mass) g.mass.assign(g.columns * g.stride, Real{0});
  if (extras.force) g.force.assign(g.columns * 2 * g.stride, Real{0});
  if (extras.averages) g.span.assign(g.columns * 2 * g.stride, Real{0});
  g.top.assign(g.columns, 0);
  return g;
}

template Grid<float> make_grid(const GridSize&, const GridExtras&);
template Grid<double> make_grid(const GridSize&, const GridExtras&);

}  // namespace leda::solver
