// Splines and transfers of one pack, once for each instruction set.

#if defined(LEDA_SOLVER_PACK_SPLINE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_PACK_SPLINE_INL
#undef LEDA_SOLVER_PACK_SPLINE_INL
#else
#define LEDA_SOLVER_PACK_SPLINE_INL
#endif

#include "hwy/highway.h"
#include "solver/kernel/pack_grid.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Quadratic B-spline (Steffen et al. 2008) along one axis, for the three nodes seen from u in
/// [0, 1) of the home cell; the node's distance is -u - 1/2, 1/2 - u, 3/2 - u cells.
template <class D>
struct PackAxis {
  hn::Vec<D> w[3];   ///< weight
  hn::Vec<D> s[3];   ///< slope, per cell
  hn::Vec<D> wd[3];  ///< weight times distance, cells
};

template <class D>
HWY_INLINE PackAxis<D> pack_axis(D d, hn::Vec<D> u) {
  PackAxis<D> a;
  const auto half = hn::Set(d, Real{0.5}), one = hn::Set(d, Real{1});
  const auto rest = hn::Sub(u, one), middle = hn::Sub(half, u);
  const auto before = hn::Sub(hn::Set(d, Real{-0.5}), u);
  a.s[0] = rest;
  a.s[1] = hn::Add(middle, middle);
  a.s[2] = u;
  a.w[0] = hn::Mul(half, hn::Mul(rest, rest));
  a.w[1] = hn::NegMulAdd(middle, middle, hn::Set(d, Real{0.75}));
  a.w[2] = hn::Mul(half, hn::Mul(u, u));
  a.wd[0] = hn::Mul(a.w[0], before);
  a.wd[1] = hn::Mul(a.w[1], middle);
  a.wd[2] = hn::Mul(a.w[2], hn::Add(middle, one));
  return a;
}

#if HWY_TARGET == HWY_SCALAR
template <class D>
HWY_INLINE hn::Vec<D> load_rows(D d, const Real* from) {
  return hn::LoadU(d, from);
}

template <class D>
HWY_INLINE void add_to_rows(D d, hn::Vec<D> value, Real* to) {
  hn::StoreU(hn::Add(hn::LoadU(d, to), value), d, to);
}
#else
/// Reads a value of the rows that the lanes live in.
template <class D>
HWY_INLINE hn::Vec<D> load_rows(D d, const Real* from) {
  if constexpr (hn::MaxLanes(D()) > Pack::rows) {
    const auto rows = hn::LoadU(hn::Half<D>(), from);
    return hn::Combine(d, rows, rows);
  } else {
    return hn::LoadU(d, from);
  }
}

/// Adds to a value of the rows that the lanes live in, first points of a row before second ones
/// whatever the width of the vectors.
template <class D>
HWY_INLINE void add_to_rows(D d, hn::Vec<D> value, Real* to) {
  if constexpr (hn::MaxLanes(D()) > Pack::rows) {
    const hn::Half<D> half;
    const auto first = hn::Add(hn::LoadU(half, to), hn::LowerHalf(half, value));
    hn::StoreU(hn::Add(first, hn::UpperHalf(half, value)), half, to);
  } else {
    hn::StoreU(hn::Add(hn::LoadU(d, to), value), d, to);
  }
}
#endif

/// Velocity (m/s), its moments sum w v d (m/s, d in cells) and its slopes (m/s per cell).
template <class D>
struct PackVelocity {
  hn::Vec<D> vx, vz;
  hn::Vec<D> mxx, mxz, mzx, mzz;
  hn::Vec<D> lxx, lxz, lzx, lzz;
};

/// From the velocities `nodes` of the first column's lowest node on; `stride` of a value there.
/// The sums run over differences along a column: the same numbers (the weights add up to one,
/// slopes and moments to nothing), and a body that moves as one has no strain to the last bit.
template <class D>
HWY_INLINE PackVelocity<D> pack_velocity(D d, const Real* nodes, std::size_t stride,
                                         const PackAxis<D>& x, const PackAxis<D>& z) {
  hn::Vec<D> value[3][2], slope[3][2], moment[3][2];
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Real* v = nodes + (2 * c + axis) * stride;
      const auto middle = load_rows(d, v + 1);
      const auto below = hn::Sub(middle, load_rows(d, v));
      const auto above = hn::Sub(load_rows(d, v + 2), middle);
      value[c][axis] = hn::MulAdd(z.w[2], above, hn::NegMulAdd(z.w[0], below, middle));
      slope[c][axis] = hn::NegMulAdd(z.s[0], below, hn::Mul(z.s[2], above));
      moment[c][axis] = hn::NegMulAdd(z.wd[0], below, hn::Mul(z.wd[2], above));
    }
  }
  const auto weigh = [&](const hn::Vec<D>(&v)[3][2], std::size_t axis) {
    return hn::MulAdd(x.w[2], v[2][axis],
                      hn::MulAdd(x.w[1], v[1][axis], hn::Mul(x.w[0], v[0][axis])));
  };
  const auto differ = [&](const hn::Vec<D>(&weight)[3], std::size_t axis) {
    const auto right = hn::Sub(value[2][axis], value[1][axis]);
    const auto left = hn::Sub(value[1][axis], value[0][axis]);
    return hn::NegMulAdd(weight[0], left, hn::Mul(weight[2], right));
  };
  return {weigh(value, 0),  weigh(value, 1), differ(x.wd, 0), weigh(moment, 0), differ(x.wd, 1),
          weigh(moment, 1), differ(x.s, 0),  weigh(slope, 0), differ(x.s, 1),   weigh(slope, 1)};
}

/// Mass that points see, sum w m over the nodes from this column and row on; zero where the grid
/// keeps none.
template <class D>
HWY_INLINE hn::Vec<D> seen_mass(D d, PackGrid& grid, std::size_t column, std::size_t row,
                                const PackAxis<D>& x, const PackAxis<D>& z) {
  auto seen = hn::Zero(d);
  if (grid.mass.empty()) return seen;
  for (std::size_t c = 0; c < 3; ++c) {
    const Real* m = grid.mass_at(column + c, row);
    const auto along =
        hn::MulAdd(z.w[2], load_rows(d, m + 2),
                   hn::MulAdd(z.w[1], load_rows(d, m + 1), hn::Mul(z.w[0], load_rows(d, m))));
    seen = hn::MulAdd(x.w[c], along, seen);
  }
  return seen;
}

/// What a pack gives to the nodes.
template <class D>
struct PackShare {
  hn::Vec<D> mass;
  hn::Vec<D> px, pz;              ///< momentum at the point
  hn::Vec<D> pxx, pxz, pzx, pzz;  ///< mass times affine velocity, per cell
  hn::Vec<D> fxx, fzz, fxz;       ///< - V sigma / h
};

/// Adds to the sums from the first column's home row on.
template <class D>
HWY_INLINE void spread_pack(D d, Real* sums, std::size_t stride, const PackAxis<D>& x,
                            const PackAxis<D>& z, const PackShare<D>& p) {
  for (std::size_t c = 0; c < 3; ++c) {
    const auto wx = x.w[c], sx = x.s[c], wdx = x.wd[c];
    const auto mass = hn::Mul(wx, p.mass);
    const auto px = hn::MulAdd(wx, p.px, hn::Mul(wdx, p.pxx)), pxz = hn::Mul(wx, p.pxz);
    const auto pz = hn::MulAdd(wx, p.pz, hn::Mul(wdx, p.pzx)), pzz = hn::Mul(wx, p.pzz);
    const auto fxx = hn::Mul(sx, p.fxx), fxz = hn::Mul(wx, p.fxz);
    const auto fzx = hn::Mul(sx, p.fxz), fzz = hn::Mul(wx, p.fzz);
    for (std::size_t j = 0; j < 3; ++j) {
      const auto wz = z.w[j], wdz = z.wd[j], sz = z.s[j];
      Real* to = sums + j * stride;
      const auto add = [&](hn::Vec<D> w1, hn::Vec<D> a, hn::Vec<D> w2, hn::Vec<D> b) {
        to += 3 * stride;
        add_to_rows(d, hn::MulAdd(w2, b, hn::Mul(w1, a)), to);
      };
      add_to_rows(d, hn::Mul(wz, mass), to);
      add(wz, px, wdz, pxz);
      add(wz, pz, wdz, pzz);
      add(wz, fxx, sz, fxz);
      add(wz, fzx, sz, fzz);
    }
    sums += PackGrid::values * PackGrid::planes * stride;
  }
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
