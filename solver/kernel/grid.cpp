#include "solver/kernel/grid.hpp"

#include <cmath>
#include <numbers>

namespace leda::solver {

GridSize grid_over(double h, double length, double height) {
  const auto cells = [h](double size) {
    return static_cast<std::size_t>(std::ceil(size / h - 1e-9));
  };
  return {h, cells(length) + 3, cells(height) + 3};
}

namespace {

constexpr double most_share = 0.25;  // of a pass: the highest mode of the nodes is gone after one

// A slip in one row of cells has the strain of a hat function, variance h^2/6; the splines of both
// transfers add h^2/4 each, a pass adds 2 share h^2. The average of a slip then stands, at its
// middle, at slip / (sqrt(2 pi) s), s^2 being the sum: that is how thick the band is.
template <class Real>
BandGrid<Real> make_band(const Grid<Real>& g, double band_m) {
  const double s = band_m / std::sqrt(2 * std::numbers::pi) / g.h;
  const double rest = s * s - 1.0 / 6 - 1.0 / 2;
  BandGrid<Real> band;
  if (rest > 0) {
    band.passes = static_cast<std::size_t>(std::ceil(rest / (2 * most_share)));
    band.share = rest / (2 * static_cast<double>(band.passes));
  }
  band.sums.assign(g.columns * Grid<Real>::planes * g.stride, Real{0});
  band.strain[0].assign(g.columns * g.stride, Real{0});
  band.active.assign(g.columns, 0);
  if (band.passes == 0) return band;
  band.strain[1] = band.mass[0] = band.mass[1] = band.strain[0];
  return band;
}

}  // namespace

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
  g.shows_mass = extras.mass;
  if (extras.band_m > 0) g.band = make_band(g, extras.band_m);
  if (extras.mass || g.band.exists()) g.mass.assign(g.columns * g.stride, Real{0});
  if (extras.force) g.force.assign(g.columns * 2 * g.stride, Real{0});
  if (extras.averages) g.span.assign(g.columns * 2 * g.stride, Real{0});
  g.top.assign(g.columns, 0);
  return g;
}

template Grid<float> make_grid(const GridSize&, const GridExtras&);
template Grid<double> make_grid(const GridSize&, const GridExtras&);

}  // namespace leda::solver
