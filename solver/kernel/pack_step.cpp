#include "solver/kernel/pack_step.hpp"

#include <algorithm>
#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solver/kernel/pack_step.cpp"
#include "hwy/foreach_target.h"
//
#include "hwy/highway.h"
#include "solver/kernel/add_pack-inl.hpp"
#include "solver/kernel/pack_spline-inl.hpp"
#include "solver/kernel/softer-inl.hpp"
#include "solver/materials/tresca-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct StepScales {
  Real dt, dt_per_h;
  Real area;  ///< of a cell, m2
};

// The points of a block of packs between the three passes of a step. The chain from strain to
// stress is long (two roots, two quotients, an exponential); a pass of its own lets the processor
// overlap the chains of several packs.
constexpr std::size_t block = 16;
struct Between {
  HWY_ALIGN Real value[block][11][Pack::lanes];  // in the order of PackVelocity; mass seen
};

template <class D>
HWY_INLINE void store_velocity(D d, const PackVelocity<D>& v, hn::Vec<D> mass,
                               Real (*to)[Pack::lanes], std::size_t l) {
  const hn::Vec<D> all[10] = {v.vx, v.vz, v.mxx, v.mxz, v.mzx, v.mzz, v.lxx, v.lxz, v.lzx, v.lzz};
  for (std::size_t i = 0; i < 10; ++i) hn::Store(all[i], d, to[i] + l);
  hn::Store(mass, d, to[10] + l);
}

// First pass: velocity and its gradient at the points. False where one has left the grid.
template <class D>
HWY_INLINE bool gather(D d, const Pack& p, const PackPlace& place, std::size_t l, PackGrid& grid,
                       Real (*to)[Pack::lanes]) {
  const auto x = hn::Load(d, p.x + l), z = hn::Load(d, p.z + l);
  const auto mass = hn::Load(d, p.mass + l);
  const auto ax = pack_axis(d, x), az = pack_axis(d, z);
  auto v = pack_velocity(d, grid.velocity_at(place.column, place.row + l % Pack::rows), grid.stride,
                         ax, az);
  auto seen = seen_mass(d, grid, place.column, place.row + l % Pack::rows, ax, az);
  const auto stray = strays(d, x, z, mass);
  bool inside = true;
  if (HWY_UNLIKELY(!hn::AllFalse(d, stray))) {
    inside = gather_strays(d, grid, place, l, stray, x, z, v, seen);
  }
  // A lane without a point stays as it is: what nodes of next to no mass do must not reach it.
  const auto point = hn::Gt(mass, hn::Zero(d));
  if (!hn::AllTrue(d, point)) {
    for (auto* value :
         {&v.vx, &v.vz, &v.mxx, &v.mxz, &v.mzx, &v.mzz, &v.lxx, &v.lxz, &v.lzx, &v.lzz}) {
      *value = hn::IfThenElseZero(point, *value);
    }
  }
  store_velocity(d, v, seen, to, l);
  return inside;
}

template <class D>
struct LaneSums {
  hn::Vec<D> work, px, pz, fastest;
  bool yields;
};

template <class D>
HWY_INLINE Moduli<hn::Vec<D>> moduli_of(D d, const Pack& p, std::size_t l, const PackLaws& laws,
                                        const LawRows<D>& row, hn::Vec<D> seen, Real area) {
  const auto bulk = row(laws.bulk), shear = row(laws.shear);
  if (!laws.softer) return {bulk, shear};
  const auto share = softer_share(d, seen, hn::Load(d, p.mass + l), hn::Load(d, p.volume + l),
                                  hn::Load(d, p.plastic_strain + l), area);
  return {hn::Mul(share, bulk), hn::Mul(share, shear)};
}

// Second pass: stress, plastic strain, volume, position.
template <class D>
HWY_INLINE void update(D d, Pack& p, std::size_t l, const PackLaws& laws, const StepScales& scale,
                       const Real (*v)[Pack::lanes], LaneSums<D>& sums) {
  const auto vx = hn::Load(d, v[0] + l), vz = hn::Load(d, v[1] + l);
  const auto lxz = hn::Load(d, v[7] + l), lzx = hn::Load(d, v[8] + l);
  const auto step = hn::Set(d, scale.dt_per_h), half_step = hn::Mul(hn::Set(d, Real{0.5}), step);
  const PlaneStrain<hn::Vec<D>> strain{hn::Mul(hn::Load(d, v[6] + l), step),
                                       hn::Mul(hn::Load(d, v[9] + l), step),
                                       hn::Mul(hn::Add(lxz, lzx), half_step)};
  const auto spin = hn::Mul(hn::Sub(lxz, lzx), half_step);
  const PlaneStress<hn::Vec<D>> old{hn::Load(d, p.sxx + l), hn::Load(d, p.szz + l),
                                    hn::Load(d, p.sxz + l), hn::Load(d, p.syy + l)};
  const auto gamma = hn::Load(d, p.plastic_strain + l);
  const auto row = law_rows(d, p.law + l, laws.rows, true);
  const auto moduli = moduli_of(d, p, l, laws, row, hn::Load(d, v[10] + l), scale.area);
  const auto next =
      next_stress<false>(d, row, laws, old, gamma, strain, spin, hn::Set(d, scale.dt), moduli);
  sums.yields = sums.yields || next.yields;
  if (next.yields) {  // Kahan's sum: what rounding takes now is added with the next step
    const auto more = hn::Sub(next.plastic_strain, hn::Load(d, p.plastic_rest + l));
    const auto sum = hn::Add(gamma, more);
    hn::Store(hn::Sub(hn::Sub(sum, gamma), more), d, p.plastic_rest + l);
    hn::Store(sum, d, p.plastic_strain + l);
  }
  hn::Store(next.stress.xx, d, p.sxx + l);
  hn::Store(next.stress.zz, d, p.szz + l);
  hn::Store(next.stress.xz, d, p.sxz + l);
  hn::Store(next.stress.yy, d, p.syy + l);
  const auto volume = hn::Load(d, p.volume + l), mass = hn::Load(d, p.mass + l);
  sums.work = hn::MulAdd(next.work, volume, sums.work);
  sums.px = hn::MulAdd(mass, vx, sums.px);
  sums.pz = hn::MulAdd(mass, vz, sums.pz);
  sums.fastest = hn::Max(sums.fastest, hn::MulAdd(vx, vx, hn::Mul(vz, vz)));
  hn::Store(hn::MulAdd(volume, hn::Add(strain.xx, strain.zz), volume), d, p.volume + l);
  hn::Store(hn::MulAdd(vx, step, hn::Load(d, p.x + l)), d, p.x + l);
  hn::Store(hn::MulAdd(vz, step, hn::Load(d, p.z + l)), d, p.z + l);
}

template <class D>
HWY_INLINE Carried<D> carried(D d, const Real (*v)[Pack::lanes], std::size_t l) {
  const auto affine = [&](std::size_t i) {
    return hn::Mul(hn::Set(d, Real{4}), hn::Load(d, v[i] + l));
  };
  return {hn::Load(d, v[0] + l), hn::Load(d, v[1] + l), affine(2), affine(3), affine(4), affine(5)};
}

template <class D>
HWY_INLINE void keep_motion(D d, const Carried<D>& m, PackMotion& kept, std::size_t l) {
  hn::Store(m.vx, d, kept.vx + l);
  hn::Store(m.vz, d, kept.vz + l);
  hn::Store(m.cxx, d, kept.cxx + l);
  hn::Store(m.cxz, d, kept.cxz + l);
  hn::Store(m.czx, d, kept.czx + l);
  hn::Store(m.czz, d, kept.czz + l);
}

// Sums over a block by lane, whatever the width of the vectors.
struct BlockSums {
  HWY_ALIGN Real work[Pack::lanes], px[Pack::lanes], pz[Pack::lanes], fastest[Pack::lanes];

  void add_to(ParticleSums& sums) const {
    for (std::size_t l = 0; l < Pack::lanes; ++l) {
      sums.stress_work += static_cast<double>(work[l]);
      sums.momentum_x += static_cast<double>(px[l]);
      sums.momentum_z += static_cast<double>(pz[l]);
      sums.fastest_squared = std::max(sums.fastest_squared, static_cast<double>(fastest[l]));
    }
  }
};

// Whether a point has yielded.
HWY_NOINLINE bool update_block(Packs& packs, std::size_t first, std::size_t count,
                               const PackLaws& laws, const StepScales& scale,
                               const Between& between, ParticleSums& sums) {
  const Lanes d;
  BlockSums block_sums{};
  bool yields = false;
  for (std::size_t l = 0; l < Pack::lanes; l += hn::Lanes(d)) {
    const auto zero = hn::Zero(d);
    LaneSums<Lanes> lane{zero, zero, zero, zero, false};
    for (std::size_t i = 0; i < count; ++i) {
      if (!any_of(packs.taken[first + i], l)) continue;
      update(d, packs.pack[first + i], l, laws, scale, between.value[i], lane);
    }
    hn::Store(lane.work, d, block_sums.work + l);
    hn::Store(lane.px, d, block_sums.px + l);
    hn::Store(lane.pz, d, block_sums.pz + l);
    hn::Store(lane.fastest, d, block_sums.fastest + l);
    yields = yields || lane.yields;
  }
  block_sums.add_to(sums);
  return yields;
}

HWY_NOINLINE bool gather_block(const Packs& packs, std::size_t first, std::size_t count,
                               PackGrid& grid, Between& between) {
  const Lanes d;
  bool inside = true;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t l = 0; l < Pack::lanes; l += hn::Lanes(d)) {
      if (!any_of(packs.taken[first + i], l)) continue;
      inside =
          gather(d, packs.pack[first + i], packs.place[first + i], l, grid, between.value[i]) &&
          inside;
    }
  }
  return inside;
}

HWY_NOINLINE bool spread_block(Packs& packs, std::size_t first, std::size_t count, bool keep,
                               PackGrid& grid, const Between& between, std::size_t& strayed) {
  const Lanes d;
  const auto per_h = static_cast<Real>(1 / grid.h);
  bool inside = true;
  for (std::size_t i = 0; i < count; ++i) {
    const auto motion_of = [&](std::size_t l) {
      const auto m = carried(d, between.value[i], l);
      if (keep) keep_motion(d, m, packs.motion[first + i], l);
      return m;
    };
    inside = add_pack(packs, first + i, grid, per_h, motion_of) && inside;
    strayed += static_cast<std::size_t>(std::popcount(packs.strayed[first + i]));
  }
  return inside;
}

PackSums StepPacks(Packs& packs, PackGrid& grid, const PackLaws& laws, double dt, bool keep,
                   std::size_t begin, std::size_t end) {
  const StepScales scale{static_cast<Real>(dt), static_cast<Real>(dt / grid.h),
                         static_cast<Real>(grid.h * grid.h)};
  PackSums total;
  Between between{};
  bool inside = true;
  for (std::size_t first = begin; first < end; first += block) {
    const std::size_t count = std::min(block, end - first);
    inside = gather_block(packs, first, count, grid, between) && inside;
    const bool yields = update_block(packs, first, count, laws, scale, between, total.particles);
    total.yields = total.yields || yields;
    inside = spread_block(packs, first, count, keep, grid, between, total.strayed) && inside;
  }
  total.left_grid = !inside;
  return total;
}

void Spread(Packs& packs, PackGrid& grid, std::size_t first, std::size_t last) {
  const Lanes d;
  const auto per_h = static_cast<Real>(1 / grid.h);
  for (std::size_t i = first; i < last; ++i) {
    const PackMotion& k = packs.motion[i];
    add_pack(packs, i, grid, per_h, [&](std::size_t l) {
      return Carried<Lanes>{hn::Load(d, k.vx + l),  hn::Load(d, k.vz + l),  hn::Load(d, k.cxx + l),
                            hn::Load(d, k.cxz + l), hn::Load(d, k.czx + l), hn::Load(d, k.czz + l)};
    });
  }
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace leda::solver {

HWY_EXPORT(StepPacks);
HWY_EXPORT(Spread);

PackSums step_packs(Packs& packs, PackGrid& grid, const PackLaws& laws, double dt, bool keep,
                    std::size_t first, std::size_t last) {
  return HWY_DYNAMIC_DISPATCH(StepPacks)(packs, grid, laws, dt, keep, first, last);
}

void spread(Packs& packs, PackGrid& grid, std::size_t first, std::size_t last) {
  HWY_DYNAMIC_DISPATCH(Spread)(packs, grid, first, last);
}

}  // namespace leda::solver
#endif
