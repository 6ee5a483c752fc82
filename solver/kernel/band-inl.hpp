// The plastic strain of a step, averaged over a band on the nodes; once for each instruction set.

#if defined(LEDA_SOLVER_BAND_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_BAND_INL
#undef LEDA_SOLVER_BAND_INL
#else
#define LEDA_SOLVER_BAND_INL
#endif

#include <algorithm>
#include <array>
#include <vector>

#include "hwy/highway.h"
#include "solver/kernel/grid_update-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Sums become averages: divided by the mass.
template <class D>
HWY_INLINE void divide_by_mass(D d, const Number<D>* mass, double h, std::size_t rows,
                               Number<D>* sums) {
  const auto least = constant(d, least_mass(h));
  for (std::size_t k = 0; k < rows; k += hn::Lanes(d)) {
    const auto m = hn::LoadU(d, mass + k);
    const auto average = hn::LoadU(d, sums + k) / hn::Max(m, least);
    hn::StoreU(hn::IfThenElseZero(hn::Gt(m, least), average), d, sums + k);
  }
}

/// The images of a column's ghost row, and of its ghost column where it has one.
template <class Real>
HWY_INLINE void mirror_band(const Grid<Real>& grid, std::vector<Real>& of, std::size_t column,
                            std::size_t rows) {
  Real* own = grid.at(of, column, 0);
  own[0] = own[2];
  const std::size_t ghost = grid.columns - 1;
  if (column == 2) std::copy_n(own, rows, grid.at(of, 0, 0));
  if (column == ghost - 2) std::copy_n(own, rows, grid.at(of, ghost, 0));
}

/// Rows that smoothing reaches in columns first to last - 1: a row more with each pass.
template <class Real>
std::size_t band_rows(const Grid<Real>& grid, std::size_t first, std::size_t last) {
  std::size_t top = 0;
  for (std::size_t i = first - 1; i <= last; ++i) top = std::max(top, grid.top[i]);
  return whole_rows(std::min(top + grid.band.passes, grid.rows));
}

/// Kernel::add_up_band. The ground goes on beyond an edge, as for the masses that the grid keeps:
/// what ghost nodes were given is folded back, and nodes on an edge count twice.
template <class D>
HWY_INLINE void add_up_band(D d, Grid<Number<D>>& grid, std::size_t first, std::size_t last) {
  using Real = Number<D>;
  BandGrid<Real>& band = grid.band;
  const std::size_t ghost = grid.columns - 1;
  std::vector<Real> beyond(grid.stride);
  first = std::max<std::size_t>(1, first);
  last = std::min(last, ghost);
  if (first >= last) return;
  const std::size_t all = band_rows(grid, first, last);
  for (std::size_t i = first; i < last; ++i) {
    const std::size_t top = whole_rows(grid.top[i]);
    Real* to = grid.at(band.strain[0], i, 0);
    combine_value(d, grid.band_sums_at(i, 0), grid.stride, top, to);
    std::fill(to + top, to + all, Real{0});  // where smoothing left the averages of a step before
    for (const auto& [own, outside] :
         {std::array{std::size_t{2}, std::size_t{0}}, std::array{ghost - 2, ghost}}) {
      if (i != own) continue;
      const std::size_t rows = whole_rows(grid.top[outside]);
      combine_value(d, grid.band_sums_at(outside, 0), grid.stride, rows,
                    beyond.data() + Grid<Real>::lead);
      for (std::size_t k = 0; k < rows; ++k) to[k] += beyond[Grid<Real>::lead + k];
    }
    to[2] += to[0];
    to[1] += to[1];
    if (i == 1 || i == ghost - 1) {
      for (std::size_t k = 0; k < top; ++k) to[k] += to[k];
    }
    if (band.passes == 0) divide_by_mass(d, grid.mass_at(i, 0), grid.h, top, to);
    mirror_band(grid, band.strain[0], i, all);
  }
}

/// One pass of (share, 1 - 2 share, share) along both axes over columns first to last - 1.
template <class D>
HWY_INLINE void smooth(D d, const Grid<Number<D>>& grid, std::vector<Number<D>>& from,
                       std::vector<Number<D>>& to, std::size_t rows, std::size_t first,
                       std::size_t last) {
  using Real = Number<D>;
  const auto share = constant(d, grid.band.share);
  std::vector<Real> room(3 * grid.stride);
  const auto column = [&](std::size_t i) { return room.data() + i % 3 * grid.stride; };
  const auto along_z = [&](std::size_t i) {
    const Real* q = grid.at(from, i, 0);
    for (std::size_t k = 0; k < rows; k += hn::Lanes(d)) {
      const auto own = hn::LoadU(d, q + k);
      const auto beside = hn::LoadU(d, q + k - 1) + hn::LoadU(d, q + k + 1);
      hn::StoreU(hn::MulAdd(share, beside - (own + own), own), d, column(i) + k);
    }
  };
  along_z(first - 1);
  along_z(first);
  for (std::size_t i = first; i < last; ++i) {
    along_z(i + 1);
    const Real *left = column(i - 1), *own = column(i), *right = column(i + 1);
    Real* q = grid.at(to, i, 0);
    for (std::size_t k = 0; k < rows; k += hn::Lanes(d)) {
      const auto middle = hn::LoadU(d, own + k);
      const auto beside = hn::LoadU(d, left + k) + hn::LoadU(d, right + k);
      hn::StoreU(hn::MulAdd(share, beside - (middle + middle), middle), d, q + k);
    }
    mirror_band(grid, to, i, rows);
  }
}

/// Kernel::smooth_band.
template <class D>
HWY_INLINE void smooth_band(D d, Grid<Number<D>>& grid, std::size_t pass, std::size_t first,
                            std::size_t last) {
  BandGrid<Number<D>>& band = grid.band;
  first = std::max<std::size_t>(1, first);
  last = std::min(last, grid.columns - 1);
  if (first >= last) return;
  const std::size_t rows = band_rows(grid, first, last);
  const std::size_t from = pass % 2, to = 1 - from;
  smooth(d, grid, band.strain[from], band.strain[to], rows, first, last);
  smooth(d, grid, pass == 0 ? grid.mass : band.mass[from], band.mass[to], rows, first, last);
  if (pass + 1 != band.passes) return;
  for (std::size_t i = first; i < last; ++i) {
    divide_by_mass(d, grid.at(band.mass[to], i, 0), grid.h, rows, grid.at(band.strain[to], i, 0));
    mirror_band(grid, band.strain[to], i, rows);
  }
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
