// What a pack gives to the nodes; once for each instruction set.

#if defined(LEDA_SOLVER_SPREAD_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_SPREAD_INL
#undef LEDA_SOLVER_SPREAD_INL
#else
#define LEDA_SOLVER_SPREAD_INL
#endif

#include "hwy/highway.h"
#include "solver/kernel/spans-inl.hpp"
#include "solver/kernel/strays-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Velocity, affine velocity (per cell) and plastic strain of the step of a vector of points.
template <class D>
struct Carried {
  hn::Vec<D> vx, vz, cxx, cxz, czx, czz, plastic_step;
};

template <class D>
HWY_INLINE Carried<D> load_motion(D d, const PackMotion<Number<D>>& m, std::size_t l) {
  return {hn::Load(d, m.vx + l),          hn::Load(d, m.vz + l),  hn::Load(d, m.cxx + l),
          hn::Load(d, m.cxz + l),         hn::Load(d, m.czx + l), hn::Load(d, m.czz + l),
          hn::Load(d, m.plastic_step + l)};
}

template <class D>
HWY_INLINE void store_motion(D d, const Carried<D>& m, PackMotion<Number<D>>& to, std::size_t l) {
  hn::Store(m.vx, d, to.vx + l);
  hn::Store(m.vz, d, to.vz + l);
  hn::Store(m.cxx, d, to.cxx + l);
  hn::Store(m.cxz, d, to.cxz + l);
  hn::Store(m.czx, d, to.czx + l);
  hn::Store(m.czz, d, to.czz + l);
  hn::Store(m.plastic_step, d, to.plastic_step + l);
}

/// `Average`: the mean of the in-plane normal stresses is replaced by its mean over the span, the
/// counterpart of averaged dilation: force and strain stay conjugate.
template <bool Average, class D>
HWY_INLINE ToNodes<hn::Vec<D>> given_by(D d, const Pack<Number<D>>& p, std::size_t l,
                                        const Carried<D>& m, Number<D> per_h, const Number<D>* span,
                                        std::size_t stride) {
  const auto mass = hn::Load(d, p.mass + l);
  const auto volume = hn::Set(d, -per_h) * hn::Load(d, p.volume + l);
  auto sxx = hn::Load(d, p.sxx + l), szz = hn::Load(d, p.szz + l);
  if constexpr (Average) {
    const auto to_mean = span_mean(d, span, stride) - mean_in_plane(d, sxx, szz);
    sxx = sxx + to_mean;
    szz = szz + to_mean;
  }
  return {mass,
          mass * m.vx,
          mass * m.vz,
          mass * m.cxx,
          mass * m.cxz,
          mass * m.czx,
          mass * m.czz,
          volume * sxx,
          volume * szz,
          volume * hn::Load(d, p.sxz + l),
          mass * m.plastic_step};
}

template <class D>
HWY_INLINE unsigned lane_bits(D d, hn::Mask<D> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  return bytes[0] | static_cast<unsigned>(bytes[1]) << 8U;
}

/// Whether a vector of lanes from lane l on has one of these.
template <class D>
HWY_INLINE bool any_of(D, LaneBits lanes, std::size_t l) {
  constexpr unsigned all = (1U << hn::MaxLanes(D())) - 1;
  return (lanes >> l & all) != 0;
}

/// Finds the lanes of pack i that have left their home cells.
template <class D>
HWY_INLINE void find_strayed(D d, Packs<Number<D>>& packs, std::size_t i) {
  const auto& p = packs.pack[i];
  unsigned strayed = 0;
  for (std::size_t l = 0; l < Pack<Number<D>>::lanes; l += hn::Lanes(d)) {
    if (!any_of(d, packs.taken[i], l)) continue;
    const auto stray =
        strays(d, hn::Load(d, p.x + l), hn::Load(d, p.z + l), hn::Load(d, p.mass + l));
    strayed |= lane_bits(d, stray) << l;
  }
  packs.strayed[i] = static_cast<LaneBits>(strayed);
}

/// Adds a vector of points to the nodes, but for the strays among them; returns those.
template <bool Average, class D>
HWY_INLINE hn::Mask<D> add_at_home(D d, Grid<Number<D>>& grid, const PackPlace& place,
                                   std::size_t l, const Pack<Number<D>>& p, const Carried<D>& m,
                                   Number<D> per_h) {
  const std::size_t row = place.row + l % Pack<Number<D>>::rows;
  const auto x = hn::Load(d, p.x + l), z = hn::Load(d, p.z + l);
  const Number<D>* span = nullptr;
  if constexpr (Average) span = grid.span_at(place.column, row);
  auto given = given_by<Average>(d, p, l, m, per_h, span, grid.stride);
  const auto stray = strays(d, x, z, given.mass);
  if (HWY_UNLIKELY(!hn::AllFalse(d, stray))) {
    for (auto* value : given.all()) *value = hn::IfThenZeroElse(stray, *value);
  }
  const auto ax = spline(d, x), az = spline(d, z);
  add_to_nodes(d, grid.sums_at(place.column, row), grid.stride, ax, az, given);
  if (grid.band.exists() && !hn::AllTrue(d, hn::Eq(given.strained, hn::Zero(d)))) {
    add_value(d, grid.band_sums_at(place.column, row), grid.stride, ax, az, given.strained);
  }
  return stray;
}

/// Adds pack i to the nodes, motion_of(l) being that of its lanes; strays after all that
/// are at home, so that the order does not depend on the width of the vectors. False where a point
/// has left the grid.
template <bool Average, class D, class MotionOf>
HWY_INLINE bool add_pack(D d, Packs<Number<D>>& packs, std::size_t i, Grid<Number<D>>& grid,
                         Number<D> per_h, const MotionOf& motion_of) {
  const auto& p = packs.pack[i];
  const PackPlace& place = packs.place[i];
  constexpr std::size_t lanes = Pack<Number<D>>::lanes;
  unsigned strayed = 0;
  for (std::size_t l = 0; l < lanes; l += hn::Lanes(d)) {
    if (!any_of(d, packs.taken[i], l)) continue;
    const auto stray = add_at_home<Average>(d, grid, place, l, p, motion_of(l), per_h);
    strayed |= lane_bits(d, stray) << l;
  }
  packs.strayed[i] = static_cast<LaneBits>(strayed);
  bool inside = true;
  for (std::size_t l = 0; strayed != 0 && l < lanes; l += hn::Lanes(d)) {
    if (!any_of(d, packs.strayed[i], l)) continue;
    const auto x = hn::Load(d, p.x + l), z = hn::Load(d, p.z + l);
    const auto given = given_by<false>(d, p, l, motion_of(l), per_h, nullptr, 0);
    const auto stray = strays(d, x, z, given.mass);
    inside = spread_strays(d, grid, place, l, stray, x, z, given) && inside;
  }
  return inside;
}

template <class D>
HWY_INLINE bool spread_packs(D d, Packs<Number<D>>& packs, Grid<Number<D>>& grid, std::size_t first,
                             std::size_t last) {
  const auto per_h = static_cast<Number<D>>(1 / grid.h);
  bool inside = true;
  for (std::size_t i = first; i < last; ++i) {
    const auto motion_of = [&](std::size_t l) {
      if (packs.moves) return load_motion(d, packs.motion[i], l);
      const auto still = hn::Zero(d);
      return Carried<D>{still, still, still, still, still, still, still};
    };
    inside = (grid.averages() ? add_pack<true>(d, packs, i, grid, per_h, motion_of)
                              : add_pack<false>(d, packs, i, grid, per_h, motion_of)) &&
             inside;
  }
  return inside;
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
