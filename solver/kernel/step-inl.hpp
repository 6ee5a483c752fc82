// From the nodes to the points and on to the nodes: the passes over the packs of one step; once for
// each instruction set.

#if defined(LEDA_SOLVER_STEP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_STEP_INL
#undef LEDA_SOLVER_STEP_INL
#else
#define LEDA_SOLVER_STEP_INL
#endif

#include <algorithm>
#include <bit>

#include "hwy/highway.h"
#include "solver/kernel/kernel.hpp"
#include "solver/kernel/softer-inl.hpp"
#include "solver/kernel/spread-inl.hpp"
#include "solver/materials/step/stress-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class Real>
struct StepScales {
  Real dt, dt_per_h;
  Real move_per_h;  ///< zero where positions are held
  Real area;        ///< of a cell, m2

  StepScales(const StepSettings& step, double h)
      : dt(static_cast<Real>(step.dt)),
        dt_per_h(static_cast<Real>(step.dt / h)),
        move_per_h(step.move ? dt_per_h : Real{0}),
        area(static_cast<Real>(h * h)) {}
};

// The points of a block of packs between the three passes of a step. The chain from strain to
// stress is long (two roots, two quotients, an exponential); a pass of its own lets the processor
// overlap the chains of several packs.
constexpr std::size_t block = 16;
template <class Real>
struct Between {
  using Lanes = Real[Pack<Real>::lanes];
  HWY_ALIGN FromNodes<Lanes> of[block];
  HWY_ALIGN Lanes plastic_step[block];  ///< of softening that goes by a band; else zero
};

// First pass: what a vector of points takes from the nodes. False where one has left the grid.
template <bool More, class D>
HWY_INLINE bool gather(D d, const Pack<Number<D>>& p, const PackPlace& place, std::size_t l,
                       Grid<Number<D>>& grid, FromNodes<Number<D>[Pack<Number<D>>::lanes]>& to) {
  const auto x = hn::Load(d, p.x + l), z = hn::Load(d, p.z + l), mass = hn::Load(d, p.mass + l);
  const std::size_t row = place.row + l % Pack<Number<D>>::rows;
  auto taken = from_nodes<More>(d, grid, place.column, row, x, z);
  const auto stray = strays(d, x, z, mass);
  bool inside = true;
  if (HWY_UNLIKELY(!hn::AllFalse(d, stray))) {
    inside = gather_strays<More>(d, grid, place, l, stray, x, z, taken);
  }
  const auto from = taken.all();
  const auto lanes = to.all();
  constexpr std::size_t taking = FromNodes<hn::Vec<D>>::taken(More);
  // A lane without a point takes nothing: velocities of nearly massless nodes must not reach it.
  const auto point = hn::Gt(mass, hn::Zero(d));
  if (!hn::AllTrue(d, point)) {
    for (std::size_t v = 0; v < taking; ++v) *from[v] = hn::IfThenElseZero(point, *from[v]);
  }
  for (std::size_t v = 0; v < taking; ++v) hn::Store(*from[v], d, *lanes[v] + l);
  return inside;
}

template <class D>
struct LaneSums {
  hn::Vec<D> work, px, pz, fastest;
  bool yields;
};

template <class D>
HWY_INLINE Moduli<hn::Vec<D>> moduli_of(D d, const Pack<Number<D>>& p, std::size_t l,
                                        const Laws<Number<D>>& laws, const LawRows<D>& row,
                                        hn::Vec<D> seen, Number<D> area) {
  const auto bulk = row(laws.bulk), shear = row(laws.shear);
  if (!laws.softer) return {bulk, shear};
  const auto share = softer_share(d, seen, hn::Load(d, p.mass + l), hn::Load(d, p.volume + l),
                                  hn::Load(d, p.plastic_strain + l), area);
  return {share * bulk, share * shear};
}

// Dilation of the step, that of the point or of its span (per second in span), over three.
template <class D>
HWY_INLINE PlaneStrain<hn::Vec<D>> averaged(D d, const PlaneStrain<hn::Vec<D>>& own,
                                            hn::Vec<D> mean) {
  const auto to_mean = constant(d, 0.5) * (mean - (own.xx + own.zz));
  return {own.xx + to_mean, own.zz + to_mean, own.xz};
}

// Adds to plastic strains. Kahan's sum: what rounding takes now is added with the next step.
template <class D>
HWY_INLINE hn::Vec<D> add_plastic(D d, Pack<Number<D>>& p, std::size_t l, hn::Vec<D> gamma,
                                  hn::Vec<D> plastic) {
  const auto more = plastic - hn::Load(d, p.plastic_rest + l);
  const auto sum = gamma + more;
  hn::Store((sum - gamma) - more, d, p.plastic_rest + l);
  hn::Store(sum, d, p.plastic_strain + l);
  return sum;
}

// The strain that softens where it is averaged over a band: what the band brought since the last
// step, for ground that has yielded itself.
template <class D>
HWY_INLINE hn::Vec<D> banded(D d, Pack<Number<D>>& p, std::size_t l, hn::Vec<D> gamma,
                             hn::Vec<D> softening) {
  const auto yielded = hn::Gt(gamma, hn::Zero(d));
  const auto more = hn::IfThenElseZero(yielded, softening);
  if (hn::AllTrue(d, hn::Eq(more, hn::Zero(d)))) return gamma;
  return add_plastic(d, p, l, gamma, more);
}

// Second pass: stress, plastic strain, volume, position. `span`: null, or where the spans of the
// points stand with the dilation of a second.
template <class P, class D>
HWY_INLINE void update(D d, P parts, Pack<Number<D>>& p, std::size_t l, const Laws<Number<D>>& laws,
                       const StepScales<Number<D>>& scale,
                       const FromNodes<Number<D>[Pack<Number<D>>::lanes]>& v,
                       Number<D>* plastic_step, const Number<D>* span, std::size_t stride,
                       LaneSums<D>& sums) {
  constexpr bool band = P::Softening::band;
  const auto vx = hn::Load(d, v.vx + l), vz = hn::Load(d, v.vz + l);
  const auto lxz = hn::Load(d, v.lxz + l), lzx = hn::Load(d, v.lzx + l);
  const auto step = hn::Set(d, scale.dt_per_h), half_step = constant(d, 0.5) * step;
  PlaneStrain<hn::Vec<D>> strain{hn::Load(d, v.lxx + l) * step, hn::Load(d, v.lzz + l) * step,
                                 (lxz + lzx) * half_step};
  if (span != nullptr) {
    strain = averaged(d, strain, hn::Set(d, scale.dt) * span_mean(d, span, stride));
  }
  const auto spin = (lxz - lzx) * half_step;
  const PlaneStress<hn::Vec<D>> old{hn::Load(d, p.sxx + l), hn::Load(d, p.szz + l),
                                    hn::Load(d, p.sxz + l), hn::Load(d, p.syy + l)};
  auto gamma = hn::Load(d, p.plastic_strain + l);
  if constexpr (band) gamma = banded(d, p, l, gamma, hn::Load(d, v.softening + l));
  const auto row = law_rows(d, p.law + l, laws.rows);
  const auto moduli = moduli_of(d, p, l, laws, row, hn::Load(d, v.seen + l), scale.area);
  const auto next =
      next_stress(d, parts, row, laws, old, gamma, strain, spin, hn::Set(d, scale.dt), moduli);
  sums.yields = sums.yields || next.yields;
  if constexpr (band) {
    hn::Store(next.plastic_strain, d, plastic_step + l);
    if (next.yields) {  // marks what has yielded
      const auto yields = hn::Gt(next.plastic_strain, hn::Zero(d));
      const auto mark = hn::IfThenElseZero(yields, constant(d, tiny<D>));
      hn::Store(hn::Max(gamma, mark), d, p.plastic_strain + l);
    }
  } else if (next.yields) {
    add_plastic(d, p, l, gamma, next.plastic_strain);
  }
  hn::Store(next.stress.xx, d, p.sxx + l);
  hn::Store(next.stress.zz, d, p.szz + l);
  hn::Store(next.stress.xz, d, p.sxz + l);
  hn::Store(next.stress.yy, d, p.syy + l);
  const auto volume = hn::Load(d, p.volume + l), mass = hn::Load(d, p.mass + l);
  sums.work = hn::MulAdd(next.work, volume, sums.work);
  sums.px = hn::MulAdd(mass, vx, sums.px);
  sums.pz = hn::MulAdd(mass, vz, sums.pz);
  sums.fastest = hn::Max(sums.fastest, hn::MulAdd(vx, vx, vz * vz));
  if (scale.move_per_h == 0) return;
  const auto move = hn::Set(d, scale.move_per_h);
  // What cracks open is no volume of the ground: its elastic energy must not grow by it.
  const auto dilation = (strain.xx + strain.zz) - next.opening;
  hn::Store(hn::MulAdd(volume, dilation, volume), d, p.volume + l);
  hn::Store(hn::MulAdd(vx, move, hn::Load(d, p.x + l)), d, p.x + l);
  hn::Store(hn::MulAdd(vz, move, hn::Load(d, p.z + l)), d, p.z + l);
}

// APIC: C = 4 / h^2 sum w v d (Jiang et al. 2015), here times the cell.
template <class D>
HWY_INLINE Carried<D> carried(D d, const Between<Number<D>>& between, std::size_t i,
                              std::size_t l) {
  const auto& v = between.of[i];
  const auto affine = [&](const Number<D>* moment) {
    return constant(d, 4) * hn::Load(d, moment + l);
  };
  return {hn::Load(d, v.vx + l),
          hn::Load(d, v.vz + l),
          affine(v.mxx),
          affine(v.mxz),
          affine(v.mzx),
          affine(v.mzz),
          hn::Load(d, between.plastic_step[i] + l)};
}

// Sums over a block by lane, whatever the width of the vectors.
template <class Real>
struct BlockSums {
  static constexpr std::size_t lanes = Pack<Real>::lanes;
  HWY_ALIGN Real work[lanes], px[lanes], pz[lanes], fastest[lanes];

  void add_to(PointSums& sums) const {
    for (std::size_t l = 0; l < lanes; ++l) {
      sums.stress_work += static_cast<double>(work[l]);
      sums.momentum_x += static_cast<double>(px[l]);
      sums.momentum_z += static_cast<double>(pz[l]);
      sums.fastest_squared = std::max(sums.fastest_squared, static_cast<double>(fastest[l]));
    }
  }
};

template <class P, class D>
HWY_NOINLINE void update_block(D d, P parts, Packs<Number<D>>& packs, std::size_t first,
                               std::size_t count, Grid<Number<D>>& grid,
                               const Laws<Number<D>>& laws, const StepScales<Number<D>>& scale,
                               Between<Number<D>>& between, PointSums& sums) {
  using Real = Number<D>;
  BlockSums<Real> of_lanes;
  for (std::size_t l = 0; l < Pack<Real>::lanes; l += hn::Lanes(d)) {
    LaneSums<D> lane{hn::Zero(d), hn::Zero(d), hn::Zero(d), hn::Zero(d), false};
    for (std::size_t i = 0; i < count; ++i) {
      if (!any_of(d, packs.taken[first + i], l)) continue;
      const PackPlace& place = packs.place[first + i];
      const Real* span =
          grid.averages() ? grid.span_at(place.column, place.row + l % Pack<Real>::rows) : nullptr;
      update(d, parts, packs.pack[first + i], l, laws, scale, between.of[i],
             between.plastic_step[i], span, grid.stride, lane);
    }
    hn::Store(lane.work, d, of_lanes.work + l);
    hn::Store(lane.px, d, of_lanes.px + l);
    hn::Store(lane.pz, d, of_lanes.pz + l);
    hn::Store(lane.fastest, d, of_lanes.fastest + l);
    sums.yields = sums.yields || lane.yields;
  }
  of_lanes.add_to(sums);
}

template <bool More, class D>
HWY_NOINLINE bool gather_block(D d, const Packs<Number<D>>& packs, std::size_t first,
                               std::size_t count, Grid<Number<D>>& grid,
                               Between<Number<D>>& between) {
  bool inside = true;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t l = 0; l < Pack<Number<D>>::lanes; l += hn::Lanes(d)) {
      if (!any_of(d, packs.taken[first + i], l)) continue;
      inside =
          gather<More>(d, packs.pack[first + i], packs.place[first + i], l, grid, between.of[i]) &&
          inside;
    }
  }
  return inside;
}

template <class D>
HWY_NOINLINE bool spread_block(D d, Packs<Number<D>>& packs, std::size_t first, std::size_t count,
                               bool keep, Grid<Number<D>>& grid, const Between<Number<D>>& between,
                               std::size_t& strayed) {
  const auto per_h = static_cast<Number<D>>(1 / grid.h);
  bool inside = true;
  for (std::size_t i = 0; i < count; ++i) {
    const auto motion_of = [&](std::size_t l) {
      const auto m = carried(d, between, i, l);
      if (keep) store_motion(d, m, packs.motion[first + i], l);
      return m;
    };
    inside = add_pack<false>(d, packs, first + i, grid, per_h, motion_of) && inside;
    strayed += static_cast<std::size_t>(std::popcount(packs.strayed[first + i]));
  }
  return inside;
}

template <class D>
HWY_NOINLINE void keep_block(D d, Packs<Number<D>>& packs, std::size_t first, std::size_t count,
                             const Between<Number<D>>& between, std::size_t& strayed) {
  for (std::size_t i = first; i < first + count; ++i) {
    for (std::size_t l = 0; l < Pack<Number<D>>::lanes; l += hn::Lanes(d)) {
      if (!any_of(d, packs.taken[i], l)) continue;
      store_motion(d, carried(d, between, i - first, l), packs.motion[i], l);
    }
    find_strayed(d, packs, i);
    strayed += static_cast<std::size_t>(std::popcount(packs.strayed[i]));
  }
}

/// Kernel::step.
template <class D>
HWY_INLINE PointSums step_packs(D d, Packs<Number<D>>& packs, Grid<Number<D>>& grid,
                                const Laws<Number<D>>& laws, const StepSettings& step, bool keep,
                                std::size_t begin, std::size_t end) {
  const StepScales<Number<D>> scale(step, grid.h);
  PointSums sums;
  Between<Number<D>> between{};
  bool inside = true;
  with_parts(laws, [&](auto parts) {
    for (std::size_t first = begin; first < end; first += block) {
      const std::size_t count = std::min(block, end - first);
      inside = (grid.shows_more() ? gather_block<true>(d, packs, first, count, grid, between)
                                  : gather_block<false>(d, packs, first, count, grid, between)) &&
               inside;
      update_block(d, parts, packs, first, count, grid, laws, scale, between, sums);
      if (grid.averages()) {
        keep_block(d, packs, first, count, between, sums.strayed);
      } else {
        inside = spread_block(d, packs, first, count, keep, grid, between, sums.strayed) && inside;
      }
    }
  });
  sums.left_grid = !inside;
  return sums;
}

/// Kernel::add_dilation.
template <class D>
HWY_INLINE void add_dilation(D d, const Packs<Number<D>>& packs, Grid<Number<D>>& grid,
                             std::size_t first, std::size_t last) {
  const auto per_h = constant(d, 1 / grid.h);
  for (std::size_t i = first; i < last; ++i) {
    const auto& p = packs.pack[i];
    const PackPlace& place = packs.place[i];
    for (std::size_t l = 0; l < Pack<Number<D>>::lanes; l += hn::Lanes(d)) {
      if (!any_of(d, packs.taken[i], l)) continue;
      const std::size_t row = place.row + l % Pack<Number<D>>::rows;
      const auto v = motion_at(d, grid.velocity_at(place.column, row), grid.stride,
                               spline(d, hn::Load(d, p.x + l)), spline(d, hn::Load(d, p.z + l)));
      const auto volume = hn::Load(d, p.volume + l);
      const auto own = hn::IfThenElseZero(hn::Gt(volume, hn::Zero(d)), per_h * (v.lxx + v.lzz));
      add_to_spans(d, grid.span_at(place.column, row), grid.stride, volume, own);
    }
  }
}

/// Kernel::steepest.
template <class D>
HWY_INLINE double steepest(D d, const Packs<Number<D>>& packs, Grid<Number<D>>& grid,
                           std::size_t first, std::size_t last) {
  auto most = hn::Zero(d);
  for (std::size_t i = first; i < last; ++i) {
    const auto& p = packs.pack[i];
    const PackPlace& place = packs.place[i];
    for (std::size_t l = 0; l < Pack<Number<D>>::lanes; l += hn::Lanes(d)) {
      if (!any_of(d, packs.taken[i], l)) continue;
      const std::size_t row = place.row + l % Pack<Number<D>>::rows;
      const auto v = motion_at(d, grid.velocity_at(place.column, row), grid.stride,
                               spline(d, hn::Load(d, p.x + l)), spline(d, hn::Load(d, p.z + l)));
      const auto point = hn::Gt(hn::Load(d, p.mass + l), hn::Zero(d));
      for (const auto slope : {v.lxx, v.lxz, v.lzx, v.lzz}) {
        most = hn::Max(most, hn::IfThenElseZero(point, hn::Abs(slope)));
      }
    }
  }
  return static_cast<double>(hn::GetLane(hn::MaxOfLanes(d, most))) / grid.h;
}

/// Kernel::add_stress.
template <class D>
HWY_INLINE void add_stress(D d, const Packs<Number<D>>& packs, Grid<Number<D>>& grid,
                           std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    const auto& p = packs.pack[i];
    const PackPlace& place = packs.place[i];
    for (std::size_t l = 0; l < Pack<Number<D>>::lanes; l += hn::Lanes(d)) {
      if (!any_of(d, packs.taken[i], l)) continue;
      const std::size_t row = place.row + l % Pack<Number<D>>::rows;
      add_to_spans(d, grid.span_at(place.column, row), grid.stride, hn::Load(d, p.volume + l),
                   mean_in_plane(d, hn::Load(d, p.sxx + l), hn::Load(d, p.szz + l)));
    }
  }
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
