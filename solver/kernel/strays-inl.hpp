// Points that have left their home cell and wait to be put into their new one, served one by one;
// once for each instruction set.

#if defined(LEDA_SOLVER_STRAYS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_STRAYS_INL
#undef LEDA_SOLVER_STRAYS_INL
#else
#define LEDA_SOLVER_STRAYS_INL
#endif

#include <cmath>

#include "hwy/highway.h"
#include "solver/kernel/spline-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class Real>
using OneLane = hn::CappedTag<Real, 1>;

/// Points of the pack that have left their home cell.
template <class D>
HWY_INLINE hn::Mask<D> strays(D d, hn::Vec<D> x, hn::Vec<D> z, hn::Vec<D> mass) {
  const auto zero = hn::Zero(d), one = constant(d, 1);
  const auto inside =
      hn::And(hn::And(hn::Ge(x, zero), hn::Lt(x, one)), hn::And(hn::Ge(z, zero), hn::Lt(z, one)));
  return hn::AndNot(inside, hn::Gt(mass, zero));
}

/// A stray's present cell and its place in it.
template <class Real>
struct Stray {
  std::size_t column, row;
  Real x, z;
};

/// False where the grid has no nodes for it.
template <class Real>
HWY_INLINE bool find_stray(const Grid<Real>& grid, const PackPlace& place, std::size_t lane, Real x,
                           Real z, Stray<Real>& s) {
  const Real dx = std::floor(x), dz = std::floor(z);
  const Real column = static_cast<Real>(place.column) + dx;
  const Real row = static_cast<Real>(place.row + lane % Pack<Real>::rows) + dz;
  if (!(column >= 0 && column + 3 <= static_cast<Real>(grid.columns) && row >= 0 &&
        row + 3 <= static_cast<Real>(grid.rows))) {
    return false;
  }
  s = {static_cast<std::size_t>(column), static_cast<std::size_t>(row), x - dx, z - dz};
  return true;
}

/// Calls one(stray, lane) for each stray of the vector; false where one of them has left the grid.
template <class D, class One>
HWY_INLINE bool for_strays(D d, const Grid<Number<D>>& grid, const PackPlace& place,
                           std::size_t first, hn::Mask<D> stray, hn::Vec<D> x, hn::Vec<D> z,
                           const One& one) {
  using Real = Number<D>;
  HWY_ALIGN Real at_x[Pack<Real>::lanes], at_z[Pack<Real>::lanes], is_stray[Pack<Real>::lanes];
  hn::Store(x, d, at_x);
  hn::Store(z, d, at_z);
  hn::Store(hn::IfThenElseZero(stray, constant(d, 1)), d, is_stray);
  bool all = true;
  for (std::size_t l = 0; l < hn::Lanes(d); ++l) {
    if (is_stray[l] == 0) continue;
    Stray<Real> s{};
    if (find_stray(grid, place, first + l, at_x[l], at_z[l], s)) {
      one(s, l);
    } else {
      all = false;
    }
  }
  return all;
}

/// What strays take from the nodes, put into their lanes.
template <bool More, class D>
HWY_NOINLINE bool gather_strays(D d, Grid<Number<D>>& grid, const PackPlace& place,
                                std::size_t first, hn::Mask<D> stray, hn::Vec<D> x, hn::Vec<D> z,
                                FromNodes<hn::Vec<D>>& taken) {
  using Real = Number<D>;
  const OneLane<Real> d1;
  constexpr std::size_t count = FromNodes<hn::Vec<D>>::count;
  HWY_ALIGN Real lanes[count][Pack<Real>::lanes];
  const auto all = taken.all();
  for (std::size_t v = 0; v < count; ++v) hn::Store(*all[v], d, lanes[v]);
  const bool inside =
      for_strays(d, grid, place, first, stray, x, z, [&](const Stray<Real>& s, std::size_t l) {
        auto own = from_nodes<More>(d1, grid, s.column, s.row, hn::Set(d1, s.x), hn::Set(d1, s.z));
        const auto one = own.all();
        for (std::size_t v = 0; v < count; ++v) lanes[v][l] = hn::GetLane(*one[v]);
      });
  for (std::size_t v = 0; v < count; ++v) *all[v] = hn::Load(d, lanes[v]);
  return inside;
}

/// Adds what strays give to the nodes of their present cells.
template <class D>
HWY_NOINLINE bool spread_strays(D d, Grid<Number<D>>& grid, const PackPlace& place,
                                std::size_t first, hn::Mask<D> stray, hn::Vec<D> x, hn::Vec<D> z,
                                ToNodes<hn::Vec<D>> given) {
  using Real = Number<D>;
  const OneLane<Real> d1;
  constexpr std::size_t count = ToNodes<hn::Vec<D>>::count;
  HWY_ALIGN Real lanes[count][Pack<Real>::lanes];
  const auto all = given.all();
  for (std::size_t v = 0; v < count; ++v) hn::Store(*all[v], d, lanes[v]);
  return for_strays(d, grid, place, first, stray, x, z, [&](const Stray<Real>& s, std::size_t l) {
    ToNodes<hn::Vec<OneLane<Real>>> own;
    const auto one = own.all();
    for (std::size_t v = 0; v < count; ++v) *one[v] = hn::Set(d1, lanes[v][l]);
    const auto ax = spline(d1, hn::Set(d1, s.x)), az = spline(d1, hn::Set(d1, s.z));
    add_to_nodes(d1, grid.sums_at(s.column, s.row), grid.stride, ax, az, own);
    if (grid.band.exists()) {
      add_value(d1, grid.band_sums_at(s.column, s.row), grid.stride, ax, az, own.strained);
    }
  });
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
