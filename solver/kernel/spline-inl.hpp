// Splines and transfers of a vector of points, once for each instruction set.

#if defined(LEDA_SOLVER_SPLINE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_SPLINE_INL
#undef LEDA_SOLVER_SPLINE_INL
#else
#define LEDA_SOLVER_SPLINE_INL
#endif

#include <array>

#include "hwy/highway.h"
#include "solver/kernel/grid.hpp"
#include "solver/materials/step/tensor-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A number of the lanes' type.
template <class D>
using Number = hn::TFromD<D>;

/// Quadratic B-spline (Steffen et al. 2008) along one axis, for the three nodes seen from u in
/// [0, 1) of the home cell; the node's distance is -u - 1/2, 1/2 - u, 3/2 - u cells.
template <class D>
struct Spline {
  hn::Vec<D> w[3];   ///< weight
  hn::Vec<D> s[3];   ///< slope, per cell
  hn::Vec<D> wd[3];  ///< weight times distance, cells
};

template <class D>
HWY_INLINE Spline<D> spline(D d, hn::Vec<D> u) {
  Spline<D> a;
  const auto half = constant(d, 0.5), one = constant(d, 1);
  const auto rest = u - one, middle = half - u, before = constant(d, -0.5) - u;
  a.s[0] = rest;
  a.s[1] = middle + middle;
  a.s[2] = u;
  a.w[0] = half * (rest * rest);
  a.w[1] = hn::NegMulAdd(middle, middle, constant(d, 0.75));
  a.w[2] = half * (u * u);
  a.wd[0] = a.w[0] * before;
  a.wd[1] = a.w[1] * middle;
  a.wd[2] = a.w[2] * (middle + one);
  return a;
}

#if HWY_TARGET == HWY_SCALAR
template <class D>
HWY_INLINE hn::Vec<D> load_rows(D d, const Number<D>* from) {
  return hn::LoadU(d, from);
}

template <class D>
HWY_INLINE void add_to_rows(D d, hn::Vec<D> value, Number<D>* to) {
  hn::StoreU(hn::Add(hn::LoadU(d, to), value), d, to);
}
#else
/// Reads a value of the rows that the lanes live in.
template <class D>
HWY_INLINE hn::Vec<D> load_rows(D d, const Number<D>* from) {
  if constexpr (hn::MaxLanes(D()) > Pack<Number<D>>::rows) {
    const auto rows = hn::LoadU(hn::Half<D>(), from);
    return hn::Combine(d, rows, rows);
  } else {
    return hn::LoadU(d, from);
  }
}

/// Adds to a value of the rows that the lanes live in, first points of a row before second ones
/// whatever the width of the vectors.
template <class D>
HWY_INLINE void add_to_rows(D d, hn::Vec<D> value, Number<D>* to) {
  if constexpr (hn::MaxLanes(D()) > Pack<Number<D>>::rows) {
    const hn::Half<D> half;
    const auto first = hn::Add(hn::LoadU(half, to), hn::LowerHalf(half, value));
    hn::StoreU(hn::Add(first, hn::UpperHalf(half, value)), half, to);
  } else {
    hn::StoreU(hn::Add(hn::LoadU(d, to), value), d, to);
  }
}
#endif

/// What points take from the nodes, a vector of points or (T an array) the lanes of a pack.
template <class T>
struct FromNodes {
  T vx, vz;              ///< velocity, m/s
  T mxx, mxz, mzx, mzz;  ///< its moments sum w v d, m/s, d in cells
  T lxx, lxz, lzx, lzz;  ///< its slopes sum v grad w, m/s per cell
  T seen;                ///< mass sum w m, kg/m; zero where the grid shows none
  T softening;           ///< plastic strain of the last step, averaged over a band; else zero

  static constexpr std::size_t count = 12;
  /// Of them, the first: the motion, and where the grid shows more than that all.
  static constexpr std::size_t taken(bool more) { return more ? count : 10; }
  std::array<T*, count> all() {
    return {&vx, &vz, &mxx, &mxz, &mzx, &mzz, &lxx, &lxz, &lzx, &lzz, &seen, &softening};
  }
};

/// Velocity, moments and slopes from the velocities `nodes` of the first column's lowest node on;
/// `stride` of a value there. The sums run over differences along a column: the same numbers (the
/// weights add up to one, slopes and moments to nothing), and a body that moves as one has no
/// strain to the last bit.
template <class D>
HWY_INLINE FromNodes<hn::Vec<D>> motion_at(D d, const Number<D>* nodes, std::size_t stride,
                                           const Spline<D>& x, const Spline<D>& z) {
  hn::Vec<D> value[3][2], slope[3][2], moment[3][2];
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Number<D>* v = nodes + (2 * c + axis) * stride;
      const auto middle = load_rows(d, v + 1);
      const auto below = middle - load_rows(d, v), above = load_rows(d, v + 2) - middle;
      value[c][axis] = hn::MulAdd(z.w[2], above, hn::NegMulAdd(z.w[0], below, middle));
      slope[c][axis] = hn::NegMulAdd(z.s[0], below, z.s[2] * above);
      moment[c][axis] = hn::NegMulAdd(z.wd[0], below, z.wd[2] * above);
    }
  }
  const auto weigh = [&](const hn::Vec<D>(&v)[3][2], std::size_t axis) {
    return hn::MulAdd(x.w[2], v[2][axis], hn::MulAdd(x.w[1], v[1][axis], x.w[0] * v[0][axis]));
  };
  const auto differ = [&](const hn::Vec<D>(&weight)[3], std::size_t axis) {
    const auto right = value[2][axis] - value[1][axis], left = value[1][axis] - value[0][axis];
    return hn::NegMulAdd(weight[0], left, weight[2] * right);
  };
  return {weigh(value, 0), weigh(value, 1),  differ(x.wd, 0), weigh(moment, 0),
          differ(x.wd, 1), weigh(moment, 1), differ(x.s, 0),  weigh(slope, 0),
          differ(x.s, 1),  weigh(slope, 1),  hn::Zero(d),     hn::Zero(d)};
}

/// sum w q over the nodes from q on, a value of the first column's lowest node.
template <class D>
HWY_INLINE hn::Vec<D> value_at(D d, const Number<D>* q, std::size_t stride, const Spline<D>& x,
                               const Spline<D>& z) {
  auto value = hn::Zero(d);
  for (std::size_t c = 0; c < 3; ++c, q += stride) {
    const auto along =
        hn::MulAdd(z.w[2], load_rows(d, q + 2),
                   hn::MulAdd(z.w[1], load_rows(d, q + 1), z.w[0] * load_rows(d, q)));
    value = hn::MulAdd(x.w[c], along, value);
  }
  return value;
}

/// All that points take from the nodes that they see from this column and row on; `More`: what
/// grid.shows_more() says.
template <bool More, class D>
HWY_INLINE FromNodes<hn::Vec<D>> from_nodes(D d, Grid<Number<D>>& grid, std::size_t column,
                                            std::size_t row, hn::Vec<D> x, hn::Vec<D> z) {
  const auto ax = spline(d, x), az = spline(d, z);
  auto taken = motion_at(d, grid.velocity_at(column, row), grid.stride, ax, az);
  if constexpr (!More) return taken;
  if (grid.shows_mass) {
    taken.seen = value_at(d, grid.mass_at(column, row), grid.stride, ax, az);
  }
  if (grid.band.exists() && grid.band.active[column] != 0) {
    taken.softening = value_at(d, grid.at(grid.band.average(), column, row), grid.stride, ax, az);
  }
  return taken;
}

/// What points give to the nodes; T as in FromNodes.
template <class T>
struct ToNodes {
  T mass;
  T px, pz;              ///< momentum at the point
  T pxx, pxz, pzx, pzz;  ///< mass times affine velocity, per cell
  T fxx, fzz, fxz;       ///< - V sigma / h
  T strained;            ///< mass times the plastic strain of the step

  static constexpr std::size_t count = 11;
  std::array<T*, count> all() {
    return {&mass, &px, &pz, &pxx, &pxz, &pzx, &pzz, &fxx, &fzz, &fxz, &strained};
  }
};

/// Adds to the sums from the first column's home row on: m_i, p_i and f_i of solver/README.md.
template <class D>
HWY_INLINE void add_to_nodes(D d, Number<D>* sums, std::size_t stride, const Spline<D>& x,
                             const Spline<D>& z, const ToNodes<hn::Vec<D>>& p) {
  using Values = Grid<Number<D>>;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto wx = x.w[c], sx = x.s[c], wdx = x.wd[c];
    const auto mass = wx * p.mass;
    const auto px = hn::MulAdd(wx, p.px, wdx * p.pxx), pxz = wx * p.pxz;
    const auto pz = hn::MulAdd(wx, p.pz, wdx * p.pzx), pzz = wx * p.pzz;
    const auto fxx = sx * p.fxx, fxz = wx * p.fxz, fzx = sx * p.fxz, fzz = wx * p.fzz;
    for (std::size_t j = 0; j < Values::planes; ++j) {
      const auto wz = z.w[j], wdz = z.wd[j], sz = z.s[j];
      Number<D>* to = sums + j * stride;
      // In the order of Grid::Value.
      const auto add = [&](hn::Vec<D> given) {
        add_to_rows(d, given, to);
        to += Values::planes * stride;
      };
      add(wz * mass);
      add(hn::MulAdd(wdz, pxz, wz * px));
      add(hn::MulAdd(wdz, pzz, wz * pz));
      add(hn::MulAdd(sz, fxz, wz * fxx));
      add(hn::MulAdd(sz, fzz, wz * fzx));
    }
    sums += Values::values * Values::planes * stride;
  }
}

/// Adds a value alone to its planes, likewise.
template <class D>
HWY_INLINE void add_value(D d, Number<D>* planes, std::size_t stride, const Spline<D>& x,
                          const Spline<D>& z, hn::Vec<D> value) {
  for (std::size_t c = 0; c < 3; ++c) {
    const auto part = x.w[c] * value;
    for (std::size_t j = 0; j < Grid<Number<D>>::planes; ++j, planes += stride) {
      add_to_rows(d, z.w[j] * part, planes);
    }
  }
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
