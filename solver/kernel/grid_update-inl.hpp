// The momentum balance on the nodes; once for each instruction set.

#if defined(LEDA_SOLVER_GRID_UPDATE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_GRID_UPDATE_INL
#undef LEDA_SOLVER_GRID_UPDATE_INL
#else
#define LEDA_SOLVER_GRID_UPDATE_INL
#endif

#include <algorithm>
#include <cmath>
#include <vector>

#include "hwy/highway.h"
#include "solver/kernel/kernel.hpp"
#include "solver/kernel/spline-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Rows are worked on eight at a time, whatever the width of the vectors.
constexpr std::size_t rows_at_once = 8;

inline std::size_t whole_rows(std::size_t rows) {
  return (rows + rows_at_once - 1) / rows_at_once * rows_at_once;
}

/// Nodes of one column: a value at row k stands at value(v)[k].
template <class Real>
struct Nodes {
  Real* first;
  std::size_t stride;
  Real* value(std::size_t v) const { return first + v * stride + Grid<Real>::lead; }
};

/// Adds up the planes of one value of a column, `top` rows of them, and clears them.
template <class D>
HWY_INLINE void combine_value(D d, Number<D>* planes, std::size_t stride, std::size_t top,
                              Number<D>* to) {
  const auto take = [&](Number<D>* from) {
    const auto value = hn::LoadU(d, from);
    hn::StoreU(hn::Zero(d), d, from);
    return value;
  };
  Number<D>*a = planes, *b = a + stride, *c = b + stride;
  for (std::size_t k = 0; k < top; k += hn::Lanes(d)) {
    hn::StoreU(take(a + k) + (take(b + k - 1) + take(c + k - 2)), d, to + k);
  }
}

/// Adds up the planes of a column, with gravity, and clears them.
template <class D>
HWY_INLINE void combine(D d, Grid<Number<D>>& grid, std::size_t column, const Nodes<Number<D>>& to,
                        Number<D> gravity) {
  using Real = Number<D>;
  using Values = Grid<Real>;
  const std::size_t top = whole_rows(grid.top[column]), stride = grid.stride;
  Real* sums = grid.sums_at(column, 0);
  for (std::size_t v = 0; v < Values::values; ++v) {
    combine_value(d, sums + Values::planes * v * stride, stride, top, to.value(v));
  }
  const Real* mass = to.value(Values::mass_sum);
  Real* force = to.value(Values::force_z);
  for (std::size_t k = 0; k < top; k += hn::Lanes(d)) {
    const auto weight = hn::Set(d, gravity);
    hn::StoreU(hn::NegMulAdd(weight, hn::LoadU(d, mass + k), hn::LoadU(d, force + k)), d,
               force + k);
  }
}

// The edges of the model, by images: what lies within half a cell of an edge also reaches one
// node outside it, and that ghost node is the image of the first node inside. Folding it back makes
// the spline space satisfy the edge condition exactly: at the sides the normal velocity is odd
// and the tangential one even (fixed horizontally), at the base both are odd (fixed both ways;
// held vertically alone, the whole bank would slide on it).

/// Adds a column of ghost nodes to the nodes inside.
template <class Real>
HWY_INLINE void fold_side(const Nodes<Real>& ghost, const Nodes<Real>& inside, std::size_t top) {
  using Values = Grid<Real>;
  for (std::size_t v = 0; v < Values::values; ++v) {
    const bool odd = v == Values::momentum_x || v == Values::force_x;
    const Real* from = ghost.value(v);
    Real* to = inside.value(v);
    for (std::size_t k = 0; k < top; ++k) to[k] += odd ? -from[k] : from[k];
  }
}

template <class Real>
HWY_INLINE void hold_side(const Nodes<Real>& edge, std::size_t top) {
  std::fill_n(edge.value(Grid<Real>::momentum_x), top, Real{0});
  std::fill_n(edge.value(Grid<Real>::force_x), top, Real{0});
}

/// Row 0 is the ghost row, row 1 lies on the base and is held.
template <class Real>
HWY_INLINE void fold_base(const Nodes<Real>& n) {
  n.value(0)[2] += n.value(0)[0];
  for (std::size_t v = 1; v < Grid<Real>::values; ++v) {
    n.value(v)[2] -= n.value(v)[0];
    n.value(v)[1] = 0;
  }
}

/// Keeps the masses of a column as if the ground went on beyond the edges, as its images do.
template <class Real>
HWY_INLINE void keep_mass(Grid<Real>& grid, std::size_t column, const Nodes<Real>& n) {
  if (grid.mass.empty()) return;
  const std::size_t top = whole_rows(grid.top[column]);
  const Real own = column == 1 || column == grid.columns - 2 ? 2 : 1;
  const Real* from = n.value(Grid<Real>::mass_sum);
  Real* to = grid.mass_at(column, 0);
  for (std::size_t k = 0; k < top; ++k) to[k] = own * from[k];
  to[1] += to[1];
  to[0] = to[2];
}

/// Keeps the unbalanced force of a column and adds up its size.
template <class Real>
HWY_INLINE void keep_force(Grid<Real>& grid, std::size_t column, const Nodes<Real>& n,
                           double gravity, GridSums& sums) {
  if (grid.force.empty()) return;
  using Values = Grid<Real>;
  const Real *mass = n.value(Values::mass_sum), *fx = n.value(Values::force_x),
             *fz = n.value(Values::force_z);
  Real *x = grid.force_at(column, 0), *z = x + grid.stride;
  const double least = least_mass(grid.h);
  for (std::size_t k = 0; k < grid.top[column]; ++k) {
    const bool full = static_cast<double>(mass[k]) > least;
    x[k] = full ? fx[k] : Real{0};
    z[k] = full ? fz[k] : Real{0};
    sums.unbalanced_force += std::abs(static_cast<double>(x[k]));
    sums.unbalanced_force += std::abs(static_cast<double>(z[k]));
    sums.weight += static_cast<double>(mass[k]) * gravity;
  }
}

template <class D>
struct NodeSums {
  hn::Vec<D> before, after, damping;
};

/// One axis of a vector of nodes: momentum balance, symplectic Euler. Returns the new velocity.
template <class D>
HWY_INLINE hn::Vec<D> accelerate(D d, hn::Vec<D> mass, hn::Vec<D> per_mass, hn::Vec<D> momentum,
                                 hn::Vec<D> force, const StepSettings& settings,
                                 NodeSums<D>& sums) {
  const auto zero = hn::Zero(d), half = constant(d, 0.5);
  const auto before = momentum * per_mass;
  const auto size = constant(d, settings.damping) * hn::Abs(force);
  const auto against = hn::IfThenElse(hn::Gt(before, zero), hn::Neg(size), size);
  const auto damp = hn::IfThenZeroElse(hn::Eq(before, zero), against);
  const auto step = constant(d, settings.dt);
  const auto after = hn::MulAdd((force + damp) * step, per_mass, before);
  sums.before = hn::MulAdd(half * mass * before, before, sums.before);
  sums.after = hn::MulAdd(half * mass * after, after, sums.after);
  const auto path = half * ((before + after) * step);
  sums.damping = hn::MulAdd(damp, path, sums.damping);
  return after;
}

/// Sum over the lanes of a column, in one order whatever the width of the vectors.
template <class Real>
double sum_lanes(const Real* lane) {
  double sum = 0;
  for (std::size_t l = 0; l < rows_at_once; ++l) sum += static_cast<double>(lane[l]);
  return sum;
}

template <class D>
HWY_INLINE void accelerate_column(D d, Grid<Number<D>>& grid, std::size_t column,
                                  const Nodes<Number<D>>& n, const StepSettings& step,
                                  GridSums& sums) {
  using Real = Number<D>;
  using Values = Grid<Real>;
  const std::size_t top = whole_rows(grid.top[column]);
  const auto least = constant(d, least_mass(grid.h));
  Real *vx = grid.velocity_at(column, 0), *vz = vx + grid.stride;
  HWY_ALIGN Real before[rows_at_once] = {}, after[rows_at_once] = {}, damped[rows_at_once] = {};
  for (std::size_t k = 0; k < top; k += rows_at_once) {
    for (std::size_t l = 0; l < rows_at_once; l += hn::Lanes(d)) {
      const std::size_t at = k + l;
      const auto load = [&](std::size_t v) { return hn::LoadU(d, n.value(v) + at); };
      auto mass = load(Values::mass_sum);
      const auto full = hn::Gt(mass, least);
      const auto per_mass = hn::IfThenElseZero(full, constant(d, 1) / hn::Max(mass, least));
      mass = hn::IfThenElseZero(full, mass);
      NodeSums<D> s{hn::Load(d, before + l), hn::Load(d, after + l), hn::Load(d, damped + l)};
      hn::StoreU(
          accelerate(d, mass, per_mass, load(Values::momentum_x), load(Values::force_x), step, s),
          d, vx + at);
      hn::StoreU(
          accelerate(d, mass, per_mass, load(Values::momentum_z), load(Values::force_z), step, s),
          d, vz + at);
      hn::Store(s.before, d, before + l);
      hn::Store(s.after, d, after + l);
      hn::Store(s.damping, d, damped + l);
    }
  }
  sums.kinetic_before += sum_lanes(before);
  sums.kinetic_after += sum_lanes(after);
  sums.damping_work += sum_lanes(damped);
}

template <class Real>
HWY_INLINE void mirror_base(Grid<Real>& grid, std::size_t column) {
  Real *vx = grid.velocity_at(column, 0), *vz = vx + grid.stride;
  vx[0] = -vx[2];
  vz[0] = -vz[2];
}

template <class Real>
HWY_INLINE void mirror_side(Grid<Real>& grid, std::size_t ghost, std::size_t inside) {
  const Real* from = grid.velocity_at(inside, 0);
  Real* to = grid.velocity_at(ghost, 0);
  const std::size_t top = whole_rows(grid.top[ghost]);
  for (std::size_t k = 0; k < top; ++k) {
    to[k] = -from[k];
    to[k + grid.stride] = from[k + grid.stride];
  }
  if (!grid.mass.empty()) std::copy_n(grid.mass_at(inside, 0), top, grid.mass_at(ghost, 0));
}

/// Kernel::update_columns.
template <class D>
HWY_INLINE GridSums update_columns(D d, Grid<Number<D>>& grid, const StepSettings& step,
                                   std::size_t first, std::size_t last) {
  using Real = Number<D>;
  constexpr std::size_t values = Grid<Real>::values;
  GridSums sums;
  const auto gravity = static_cast<Real>(step.gravity);
  const std::size_t ghost = grid.columns - 1;
  std::vector<Real> room(2 * values * grid.stride);
  const Nodes<Real> own{room.data(), grid.stride};
  const Nodes<Real> beyond{room.data() + values * grid.stride, grid.stride};
  const auto fold = [&](std::size_t from) {
    combine(d, grid, from, beyond, gravity);
    fold_side(beyond, own, whole_rows(grid.top[from]));
  };
  for (std::size_t i = first; i < last; ++i) {
    if (grid.top[i] < 3) continue;
    combine(d, grid, i, own, gravity);
    if (i == 2) fold(0);
    if (i == ghost - 2) fold(ghost);
    if (i == 1 || i == ghost - 1) hold_side(own, whole_rows(grid.top[i]));
    fold_base(own);
    keep_mass(grid, i, own);
    // Row 0 is a ghost row: what it had was folded, and it must not count again.
    for (std::size_t v = 0; v < values; ++v) own.value(v)[0] = 0;
    keep_force(grid, i, own, step.gravity, sums);
    accelerate_column(d, grid, i, own, step, sums);
    mirror_base(grid, i);
    if (i == 2) mirror_side(grid, 0, i);
    if (i == ghost - 2) mirror_side(grid, ghost, i);
  }
  return sums;
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
