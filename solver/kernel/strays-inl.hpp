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
#include "solver/kernel/pack_spline-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using OneLane = hn::CappedTag<Real, 1>;

// Points of the pack that have left their home cell.
template <class D>
HWY_INLINE hn::Mask<D> strays(D d, hn::Vec<D> x, hn::Vec<D> z, hn::Vec<D> mass) {
  const auto zero = hn::Zero(d), one = hn::Set(d, Real{1});
  const auto inside =
      hn::And(hn::And(hn::Ge(x, zero), hn::Lt(x, one)), hn::And(hn::Ge(z, zero), hn::Lt(z, one)));
  return hn::AndNot(inside, hn::Gt(mass, zero));
}

// A stray's present cell and its place in it.
struct Stray {
  std::size_t column, row;
  Real x, z;
};

// False where the grid has no nodes for it.
HWY_INLINE bool find_stray(const PackGrid& grid, const PackPlace& place, std::size_t lane, Real x,
                           Real z, Stray& s) {
  const Real dx = std::floor(x), dz = std::floor(z);
  const Real column = static_cast<Real>(place.column) + dx;
  const Real row = static_cast<Real>(place.row + lane % Pack::rows) + dz;
  if (!(column >= 0 && column + 3 <= static_cast<Real>(grid.columns) && row >= 0 &&
        row + 3 <= static_cast<Real>(grid.rows))) {
    return false;
  }
  s = {static_cast<std::size_t>(column), static_cast<std::size_t>(row), x - dx, z - dz};
  return true;
}

// Calls one(stray, lane) for each stray of the vector; false where one of them has left the grid.
template <class D, class One>
HWY_INLINE bool for_strays(D d, const PackGrid& grid, const PackPlace& place, std::size_t first,
                           hn::Mask<D> stray, hn::Vec<D> x, hn::Vec<D> z, const One& one) {
  HWY_ALIGN Real at_x[Pack::lanes], at_z[Pack::lanes], is_stray[Pack::lanes];
  hn::Store(x, d, at_x);
  hn::Store(z, d, at_z);
  hn::Store(hn::IfThenElseZero(stray, hn::Set(d, Real{1})), d, is_stray);
  bool all = true;
  for (std::size_t l = 0; l < hn::Lanes(d); ++l) {
    if (is_stray[l] == 0) continue;
    Stray s{};
    if (find_stray(grid, place, first + l, at_x[l], at_z[l], s)) {
      one(s, l);
    } else {
      all = false;
    }
  }
  return all;
}

// The motion of strays, put into their lanes.
template <class D>
HWY_NOINLINE bool gather_strays(D d, PackGrid& grid, const PackPlace& place, std::size_t first,
                                hn::Mask<D> stray, hn::Vec<D> x, hn::Vec<D> z,
                                PackVelocity<D>& velocity, hn::Vec<D>& mass) {
  const OneLane d1;
  HWY_ALIGN Real lanes[11][Pack::lanes];
  hn::Vec<D>* all[11] = {&velocity.vx,  &velocity.vz,  &velocity.mxx, &velocity.mxz,
                         &velocity.mzx, &velocity.mzz, &velocity.lxx, &velocity.lxz,
                         &velocity.lzx, &velocity.lzz, &mass};
  for (std::size_t v = 0; v < 11; ++v) hn::Store(*all[v], d, lanes[v]);
  const bool inside =
      for_strays(d, grid, place, first, stray, x, z, [&](const Stray& s, std::size_t l) {
        const auto ax = pack_axis(d1, hn::Set(d1, s.x)), az = pack_axis(d1, hn::Set(d1, s.z));
        const auto o = pack_velocity(d1, grid.velocity_at(s.column, s.row), grid.stride, ax, az);
        const auto m = seen_mass(d1, grid, s.column, s.row, ax, az);
        const hn::Vec<OneLane> one[11] = {o.vx,  o.vz,  o.mxx, o.mxz, o.mzx, o.mzz,
                                          o.lxx, o.lxz, o.lzx, o.lzz, m};
        for (std::size_t v = 0; v < 11; ++v) lanes[v][l] = hn::GetLane(one[v]);
      });
  for (std::size_t v = 0; v < 11; ++v) *all[v] = hn::Load(d, lanes[v]);
  return inside;
}

template <class D>
HWY_NOINLINE bool spread_strays(D d, PackGrid& grid, const PackPlace& place, std::size_t first,
                                hn::Mask<D> stray, hn::Vec<D> x, hn::Vec<D> z,
                                const PackShare<D>& share) {
  const OneLane d1;
  HWY_ALIGN Real lanes[10][Pack::lanes];
  const hn::Vec<D> all[10] = {share.mass, share.px,  share.pz,  share.pxx, share.pxz,
                              share.pzx,  share.pzz, share.fxx, share.fzz, share.fxz};
  for (std::size_t v = 0; v < 10; ++v) hn::Store(all[v], d, lanes[v]);
  return for_strays(d, grid, place, first, stray, x, z, [&](const Stray& s, std::size_t l) {
    const auto value = [&](std::size_t v) { return hn::Set(d1, lanes[v][l]); };
    spread_pack(d1, grid.sums_at(s.column, s.row), grid.stride, pack_axis(d1, hn::Set(d1, s.x)),
                pack_axis(d1, hn::Set(d1, s.z)),
                PackShare<OneLane>{value(0), value(1), value(2), value(3), value(4), value(5),
                                   value(6), value(7), value(8), value(9)});
  });
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
