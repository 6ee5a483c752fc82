// Yield part of a law: Tresca with a tension cut-off (Rankine), in the plane and across it:
//
//   largest - smallest principal stress <= 2 s,   largest <= T
//
// Returned by closest projection in the elastic metric, associated, to faces, edges and the apex.
// What cracks open is volume of the crack, not of the ground; that it closes again is not
// remembered. T falls as s does: ground that is remolded holds no more tension than shear. Source:
// de Souza Neto, Peric and Owen 2008, 8.1 (closest point, multisurface); Rankine's criterion as in
// Bazant and Cedolin 1991, 10. Ground that drains has the strength s of mohr-coulomb-inl.hpp.

#if defined(LEDA_SOLVER_TENSION_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_TENSION_INL
#undef LEDA_SOLVER_TENSION_INL
#else
#define LEDA_SOLVER_TENSION_INL
#endif

#include "hwy/highway.h"
#include "solver/materials/step/mohr-coulomb-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct TrescaWithTension {
  template <class D, class Laws>
  static HWY_INLINE Limits<D> limits(D d, const LawRows<D>& row, const Laws& laws,
                                     const Principal<D>& p, hn::Vec<D> s) {
    const auto tension = row(laws.tension) * (s / row(laws.peak));
    if (!laws.drains) return {s, tension};
    const auto sin = row(laws.sin_friction), pore = row(laws.pore_pressure);
    const Friction<D> friction{s, sin, pore, tension - pore};
    const auto drains = hn::Gt(sin, hn::Zero(d));
    return {hn::IfThenElse(drains, friction_strength(d, p, friction), s), friction.tension};
  }

  template <class D>
  static HWY_INLINE hn::Mask<D> yields(D d, const Principal<D>& p, const Limits<D>& limit) {
    return hn::Or(Tresca::yields(d, p, limit), hn::Gt(p.high, limit.tension));
  }

  template <class D>
  static HWY_INLINE hn::Vec<D> excess(D d, const Principal<D>& p, const Limits<D>& limit) {
    return Tresca::excess(d, p, limit);
  }

  template <class D>
  static HWY_INLINE Returned<D> returned(D d, const PlaneStress<hn::Vec<D>>& trial,
                                         const Principal<D>& p, const Limits<D>& limit,
                                         const Moduli<hn::Vec<D>>& moduli) {
    const auto a = across(d, trial, p);
    const auto from = in_order(d, trial, p, a);
    auto to = to_tresca(d, from, limit.shear);
    const auto cracks = hn::Gt(to.high, limit.tension);
    if (HWY_UNLIKELY(!hn::AllFalse(d, cracks))) {
      const auto cut = to_tension(d, from, limit, moduli);
      to = {hn::IfThenElse(cracks, cut.high, to.high), hn::IfThenElse(cracks, cut.mid, to.mid),
            hn::IfThenElse(cracks, cut.low, to.low)};
    }
    const auto dh = from.high - to.high, dm = from.mid - to.mid, dl = from.low - to.low;
    const auto mean = constant(d, 1.0 / 3.0) * (dh + dm + dl);
    const auto h = dh - mean, m = dm - mean, l = dl - mean;
    const auto square = hn::MulAdd(h, h, hn::MulAdd(m, m, l * l));
    // gamma = sqrt(2 e':e'), e' = ds' / (2 G) the deviator: what opens a crack softens nothing.
    return {in_plane(d, to, a, p, trial), hn::Sqrt(constant(d, 0.5) * square) / moduli.shear,
            mean / moduli.bulk};
  }

 private:
  /// Where the largest principal stress is T at the closest point: on the face of tension alone, or
  /// on an edge or corner of it. Each is tried in turn; what it would violate is active too.
  template <class D>
  static HWY_INLINE InOrder<D> to_tension(D d, const InOrder<D>& from, const Limits<D>& limit,
                                          const Moduli<hn::Vec<D>>& moduli) {
    const auto t = limit.tension, bottom = t - (limit.shear + limit.shear);
    const auto g2 = moduli.shear + moduli.shear;
    const auto lame = hn::NegMulAdd(constant(d, 2.0 / 3.0), moduli.shear, moduli.bulk);
    const auto two = lame + lame + g2;
    const auto face = lame * ((from.high - t) / (lame + g2));
    const auto mid = from.mid - face, low = from.low - face;  // tension alone
    const auto low_of_two = from.low - lame * ((from.high + from.mid - (t + t)) / two);
    const auto mid_of_both = from.mid - lame * ((from.high + from.low - (t + bottom)) / two);
    const auto two_tensions = hn::Gt(mid, t);
    const auto shears = hn::Lt(hn::IfThenElse(two_tensions, low_of_two, low), bottom);
    const auto mid_sheared = hn::Max(hn::Min(mid_of_both, t), bottom);
    const auto mid_alone = hn::Min(mid, t);
    const auto low_alone = hn::Min(hn::IfThenElse(two_tensions, low_of_two, low), t);
    return {t, hn::IfThenElse(shears, mid_sheared, mid_alone),
            hn::IfThenElse(shears, bottom, low_alone)};
  }
};

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
