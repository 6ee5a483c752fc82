// Third pass of a step: what a pack gives to the nodes; once for each instruction set.

#if defined(LEDA_SOLVER_ADD_PACK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_ADD_PACK_INL
#undef LEDA_SOLVER_ADD_PACK_INL
#else
#define LEDA_SOLVER_ADD_PACK_INL
#endif

#include "hwy/highway.h"
#include "solver/kernel/pack_spline-inl.hpp"
#include "solver/kernel/strays-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<Real, Pack::lanes>;

// Velocity and affine velocity (per cell) of a vector of points.
template <class D>
struct Carried {
  hn::Vec<D> vx, vz, cxx, cxz, czx, czz;
};

template <class D>
HWY_INLINE PackShare<D> share(D d, const Pack& p, std::size_t l, const Carried<D>& m, Real per_h) {
  const auto mass = hn::Load(d, p.mass + l);
  const auto volume = hn::Mul(hn::Set(d, -per_h), hn::Load(d, p.volume + l));
  return {mass,
          hn::Mul(mass, m.vx),
          hn::Mul(mass, m.vz),
          hn::Mul(mass, m.cxx),
          hn::Mul(mass, m.cxz),
          hn::Mul(mass, m.czx),
          hn::Mul(mass, m.czz),
          hn::Mul(volume, hn::Load(d, p.sxx + l)),
          hn::Mul(volume, hn::Load(d, p.szz + l)),
          hn::Mul(volume, hn::Load(d, p.sxz + l))};
}

template <class D>
HWY_INLINE unsigned lane_bits(D d, hn::Mask<D> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  return bytes[0] | static_cast<unsigned>(bytes[1]) << 8U;
}

// Adds a vector of points to the nodes, but for the strays among them; returns those.
template <class D>
HWY_INLINE hn::Mask<D> add_to_nodes(D d, PackGrid& grid, const PackPlace& place, std::size_t l,
                                    const Pack& p, const Carried<D>& m, Real per_h) {
  const auto x = hn::Load(d, p.x + l), z = hn::Load(d, p.z + l);
  auto given = share(d, p, l, m, per_h);
  const auto stray = strays(d, x, z, given.mass);
  if (HWY_UNLIKELY(!hn::AllFalse(d, stray))) {
    for (auto* value : {&given.mass, &given.px, &given.pz, &given.pxx, &given.pxz, &given.pzx,
                        &given.pzz, &given.fxx, &given.fzz, &given.fxz}) {
      *value = hn::IfThenZeroElse(stray, *value);
    }
  }
  spread_pack(d, grid.sums_at(place.column, place.row + l % Pack::rows), grid.stride,
              pack_axis(d, x), pack_axis(d, z), given);
  return stray;
}

// Whether a vector of lanes from lane l on has one of these.
HWY_INLINE bool any_of(LaneBits lanes, std::size_t l) {
  constexpr unsigned all = (1U << hn::MaxLanes(Lanes())) - 1;
  return (lanes >> l & all) != 0;
}

// Adds pack i to the nodes, motion_of(l) being that of its lanes; strays after all that
// are at home, so that the order does not depend on the width of the vectors. False where a point
// has left the grid.
template <class MotionOf>
HWY_INLINE bool add_pack(Packs& packs, std::size_t i, PackGrid& grid, Real per_h,
                         const MotionOf& motion_of) {
  const Lanes d;
  const Pack& p = packs.pack[i];
  const PackPlace& place = packs.place[i];
  unsigned strayed = 0;
  for (std::size_t l = 0; l < Pack::lanes; l += hn::Lanes(d)) {
    if (!any_of(packs.taken[i], l)) continue;
    const auto stray = add_to_nodes(d, grid, place, l, p, motion_of(l), per_h);
    strayed |= lane_bits(d, stray) << l;
  }
  packs.strayed[i] = static_cast<LaneBits>(strayed);
  bool inside = true;
  for (std::size_t l = 0; strayed != 0 && l < Pack::lanes; l += hn::Lanes(d)) {
    if (!any_of(packs.strayed[i], l)) continue;
    const auto x = hn::Load(d, p.x + l), z = hn::Load(d, p.z + l);
    const auto given = share(d, p, l, motion_of(l), per_h);
    const auto stray = strays(d, x, z, given.mass);
    inside = spread_strays(d, grid, place, l, stray, x, z, given) && inside;
  }
  return inside;
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
