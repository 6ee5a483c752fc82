#include <algorithm>
#include <vector>

#include "solver/kernel/pack_grid.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solver/kernel/pack_grid_update.cpp"
#include "hwy/foreach_target.h"
//
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t lanes = 8;
using Lanes = hn::CappedTag<Real, lanes>;
constexpr Real least_mass = 1e-14F * 1000;  // as in grid_update.cpp: below it there is round-off

// Nodes of one column: a value at row k stands at value(v)[k].
struct Nodes {
  Real* first;
  std::size_t stride;
  Real* value(std::size_t v) const { return first + v * stride + PackGrid::lead; }
};

std::size_t whole_vectors(std::size_t rows) { return (rows + lanes - 1) / lanes * lanes; }

// Adds up the planes of a column, with gravity, and clears them.
HWY_INLINE void combine(PackGrid& grid, std::size_t column, const Nodes& to, Real gravity) {
  const Lanes d;
  const std::size_t top = whole_vectors(grid.top[column]);
  Real* sums = grid.sums_at(column, 0);
  const std::size_t stride = grid.stride;
  const auto take = [&](Real* from) {
    const auto value = hn::LoadU(d, from);
    hn::StoreU(hn::Zero(d), d, from);
    return value;
  };
  for (std::size_t v = 0; v < PackGrid::values; ++v) {
    Real *a = sums + 3 * v * stride, *b = a + stride, *c = b + stride;
    Real* node = to.value(v);
    for (std::size_t k = 0; k < top; k += hn::Lanes(d)) {
      const auto sum = hn::Add(take(a + k), hn::Add(take(b + k - 1), take(c + k - 2)));
      hn::StoreU(sum, d, node + k);
    }
  }
  const Real* mass = to.value(0);
  Real* force = to.value(4);
  for (std::size_t k = 0; k < top; k += hn::Lanes(d)) {
    const auto f =
        hn::NegMulAdd(hn::Set(d, gravity), hn::LoadU(d, mass + k), hn::LoadU(d, force + k));
    hn::StoreU(f, d, force + k);
  }
}

// Adds an image column to the nodes inside: the normal momentum and force are odd (boundary.hpp).
HWY_INLINE void fold_side(const Nodes& image, const Nodes& inside, std::size_t top) {
  for (std::size_t v = 0; v < PackGrid::values; ++v) {
    const bool odd = v == 1 || v == 3;
    const Real* from = image.value(v);
    Real* to = inside.value(v);
    for (std::size_t k = 0; k < top; ++k) to[k] += odd ? -from[k] : from[k];
  }
}

HWY_INLINE void hold_side(const Nodes& edge, std::size_t top) {
  std::fill_n(edge.value(1), top, Real{0});
  std::fill_n(edge.value(3), top, Real{0});
}

// The base: momentum and force are odd on both axes, and row 1 is held.
HWY_INLINE void fold_base(const Nodes& n) {
  n.value(0)[2] += n.value(0)[0];
  for (std::size_t v = 1; v < PackGrid::values; ++v) {
    n.value(v)[2] -= n.value(v)[0];
    n.value(v)[1] = 0;
  }
}

// Keeps the masses of a column as if the ground went on beyond the edges, as its images do.
HWY_INLINE void keep_mass(PackGrid& grid, std::size_t column, const Nodes& n) {
  if (grid.mass.empty()) return;
  const std::size_t top = whole_vectors(grid.top[column]);
  const Real own = column == 1 || column == grid.columns - 2 ? 2 : 1;
  const Real* from = n.value(0);
  Real* to = grid.mass_at(column, 0);
  for (std::size_t k = 0; k < top; ++k) to[k] = own * from[k];
  to[1] += to[1];
  to[0] = to[2];
}

struct LaneSums {
  hn::Vec<Lanes> before, after, damping;
};

// One axis of a vector of nodes; see grid_update.cpp.
HWY_INLINE hn::Vec<Lanes> accelerate(hn::Vec<Lanes> mass, hn::Vec<Lanes> per_mass,
                                     hn::Vec<Lanes> momentum, hn::Vec<Lanes> force, Real damping,
                                     Real dt, LaneSums& sums) {
  const Lanes d;
  const auto zero = hn::Zero(d), half = hn::Set(d, Real{0.5});
  const auto before = hn::Mul(momentum, per_mass);
  const auto size = hn::Mul(hn::Set(d, damping), hn::Abs(force));
  const auto against = hn::IfThenElse(hn::Gt(before, zero), hn::Neg(size), size);
  const auto damp = hn::IfThenZeroElse(hn::Eq(before, zero), against);
  const auto step = hn::Set(d, dt);
  const auto after = hn::MulAdd(hn::Mul(hn::Add(force, damp), step), per_mass, before);
  sums.before = hn::MulAdd(hn::Mul(hn::Mul(half, mass), before), before, sums.before);
  sums.after = hn::MulAdd(hn::Mul(hn::Mul(half, mass), after), after, sums.after);
  const auto path = hn::Mul(half, hn::Mul(hn::Add(before, after), step));
  sums.damping = hn::MulAdd(damp, path, sums.damping);
  return after;
}

// Sum over the lanes of a column, in one order whatever the width of the vectors.
double sum_lanes(const Real* lane) {
  double sum = 0;
  for (std::size_t l = 0; l < lanes; ++l) sum += static_cast<double>(lane[l]);
  return sum;
}

HWY_INLINE void accelerate_column(PackGrid& grid, std::size_t column, const Nodes& n,
                                  const GridStep& step, GridSums& sums) {
  const Lanes d;
  const std::size_t top = whole_vectors(grid.top[column]);
  const Real least = least_mass * static_cast<Real>(grid.h * grid.h);
  const Real dt = static_cast<Real>(step.dt), damping = static_cast<Real>(step.damping);
  Real *vx = grid.velocity_at(column, 0), *vz = vx + grid.stride;
  HWY_ALIGN Real before[lanes] = {}, after[lanes] = {}, damped[lanes] = {};
  for (std::size_t k = 0; k < top; k += lanes) {
    for (std::size_t l = 0; l < lanes; l += hn::Lanes(d)) {
      const std::size_t at = k + l;
      auto mass = hn::LoadU(d, n.value(0) + at);
      const auto full = hn::Gt(mass, hn::Set(d, least));
      const auto per_mass =
          hn::IfThenElseZero(full, hn::Div(hn::Set(d, Real{1}), hn::Max(mass, hn::Set(d, least))));
      mass = hn::IfThenElseZero(full, mass);
      LaneSums s{hn::Load(d, before + l), hn::Load(d, after + l), hn::Load(d, damped + l)};
      const auto x = accelerate(mass, per_mass, hn::LoadU(d, n.value(1) + at),
                                hn::LoadU(d, n.value(3) + at), damping, dt, s);
      const auto z = accelerate(mass, per_mass, hn::LoadU(d, n.value(2) + at),
                                hn::LoadU(d, n.value(4) + at), damping, dt, s);
      hn::StoreU(x, d, vx + at);
      hn::StoreU(z, d, vz + at);
      hn::Store(s.before, d, before + l);
      hn::Store(s.after, d, after + l);
      hn::Store(s.damping, d, damped + l);
    }
  }
  sums.kinetic_before += sum_lanes(before);
  sums.kinetic_after += sum_lanes(after);
  sums.damping_work += sum_lanes(damped);
}

HWY_INLINE void mirror_base(PackGrid& grid, std::size_t column) {
  Real *vx = grid.velocity_at(column, 0), *vz = vx + grid.stride;
  vx[0] = -vx[2];
  vz[0] = -vz[2];
}

HWY_INLINE void mirror_side(PackGrid& grid, std::size_t image, std::size_t inside) {
  const Real* from = grid.velocity_at(inside, 0);
  Real* to = grid.velocity_at(image, 0);
  const std::size_t top = whole_vectors(grid.top[image]);
  for (std::size_t k = 0; k < top; ++k) {
    to[k] = -from[k];
    to[k + grid.stride] = from[k + grid.stride];
  }
  if (!grid.mass.empty()) std::copy_n(grid.mass_at(inside, 0), top, grid.mass_at(image, 0));
}

GridSums UpdateColumns(PackGrid& grid, const GridStep& step, std::size_t first, std::size_t last) {
  GridSums sums;
  const auto gravity = static_cast<Real>(step.gravity);
  const std::size_t image = grid.columns - 1;
  std::vector<Real> room(2 * PackGrid::values * grid.stride);
  const Nodes own{room.data(), grid.stride};
  const Nodes beyond{room.data() + PackGrid::values * grid.stride, grid.stride};
  const auto fold = [&](std::size_t from) {
    combine(grid, from, beyond, gravity);
    fold_side(beyond, own, whole_vectors(grid.top[from]));
  };
  for (std::size_t i = first; i < last; ++i) {
    if (grid.top[i] < 3) continue;
    combine(grid, i, own, gravity);
    if (i == 2) fold(0);
    if (i == image - 2) fold(image);
    if (i == 1 || i == image - 1) hold_side(own, whole_vectors(grid.top[i]));
    fold_base(own);
    keep_mass(grid, i, own);
    // Row 0 is an image: what it had was folded, and it must not count again.
    for (std::size_t v = 0; v < PackGrid::values; ++v) own.value(v)[0] = 0;
    accelerate_column(grid, i, own, step, sums);
    mirror_base(grid, i);
    if (i == 2) mirror_side(grid, 0, i);
    if (i == image - 2) mirror_side(grid, image, i);
  }
  return sums;
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace leda::solver {

HWY_EXPORT(UpdateColumns);

GridSums update_columns(PackGrid& grid, const GridStep& step, std::size_t first, std::size_t last) {
  return HWY_DYNAMIC_DISPATCH(UpdateColumns)(grid, step, first, last);
}

}  // namespace leda::solver
#endif
