// Yield part of a law: Tresca with a tension cut-off (Rankine), in the plane and across it:
//
//   largest - smallest principal stress <= 2 s,   largest <= T
//
// Returned by closest projection in the elastic metric, associated. Both surfaces together are a
// convex body with flat faces; the closest point of it is the projection onto the plane of one of
// its faces, edges or corners, the nearest of those that lie within it. T falls as s does: ground
// that is remolded holds no more tension than shear.
// Source: de Souza Neto, Peric and Owen 2008, 8.1 (closest point, multisurface); Rankine's
// criterion as in Bazant and Cedolin 1991, 10.

#if defined(LEDA_SOLVER_TENSION_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_TENSION_INL
#undef LEDA_SOLVER_TENSION_INL
#else
#define LEDA_SOLVER_TENSION_INL
#endif

#include "hwy/highway.h"
#include "solver/materials/step/tresca-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct TrescaWithTension {
  template <class D, class Laws>
  static HWY_INLINE Limits<D> limits(D, const LawRows<D>& row, const Laws& laws, hn::Vec<D> s) {
    return {s, row(laws.tension) * (s / row(laws.peak))};
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
    return {in_plane(d, to, a, p, trial), hn::Sqrt(constant(d, 0.5) * square) / moduli.shear};
  }

 private:
  /// The nearest of the points tried so far that lie within the body.
  template <class D>
  struct Nearest {
    InOrder<D> point;
    hn::Vec<D> far;  ///< its distance from the trial stress, squared, in the elastic metric
  };

  template <class D>
  static HWY_INLINE void consider(D, const InOrder<D>& from, const InOrder<D>& at,
                                  hn::Mask<D> is_within, hn::Vec<D> volume_share,
                                  Nearest<D>& nearest) {
    const auto h = from.high - at.high, m = from.mid - at.mid, l = from.low - at.low;
    const auto sum = h + m + l;
    const auto square = hn::MulAdd(h, h, hn::MulAdd(m, m, l * l));
    const auto far = hn::NegMulAdd(volume_share * sum, sum, square);  // times 1 / (2 G)
    const auto nearer = hn::And(is_within, hn::Lt(far, nearest.far));
    nearest.point = {hn::IfThenElse(nearer, at.high, nearest.point.high),
                     hn::IfThenElse(nearer, at.mid, nearest.point.mid),
                     hn::IfThenElse(nearer, at.low, nearest.point.low)};
    nearest.far = hn::IfThenElse(nearer, far, nearest.far);
  }

  /// Where the largest principal stress is T at the closest point.
  template <class D>
  static HWY_INLINE InOrder<D> to_tension(D d, const InOrder<D>& from, const Limits<D>& limit,
                                          const Moduli<hn::Vec<D>>& moduli) {
    const auto zero = hn::Zero(d), t = limit.tension, bottom = t - (limit.shear + limit.shear);
    const auto g2 = moduli.shear + moduli.shear;
    const auto lame = hn::NegMulAdd(constant(d, 2.0 / 3.0), moduli.shear, moduli.bulk);
    const auto volume_share = lame / hn::MulAdd(constant(d, 3), lame, g2);
    const auto tested = [&](const InOrder<D>& at, Nearest<D>& nearest) {
      const auto within = hn::And(hn::And(hn::Le(at.mid, t), hn::Ge(at.mid, at.low)),
                                  hn::And(hn::Ge(at.low, bottom), hn::Le(at.low, t)));
      consider(d, from, at, within, volume_share, nearest);
    };
    // The corners are always within: T T T, T T T-2s, T T-2s T-2s.
    const auto all = hn::Eq(zero, zero);
    Nearest<D> nearest{{t, t, t}, constant(d, sizeof(hn::TFromD<D>) == 4 ? 3e38 : 1e300)};
    consider(d, from, {t, t, t}, all, volume_share, nearest);
    consider(d, from, {t, t, bottom}, all, volume_share, nearest);
    consider(d, from, {t, bottom, bottom}, all, volume_share, nearest);
    // The face of tension alone.
    const auto face = lame * ((from.high - t) / (lame + g2));
    tested({t, from.mid - face, from.low - face}, nearest);
    // The edge of two tensions.
    const auto two = lame + lame + g2;
    const auto edge = lame * ((from.high + from.mid - (t + t)) / two);
    tested({t, t, from.low - edge}, nearest);
    // The edge of tension and shear.
    const auto both = lame * ((from.high + from.low - (t + bottom)) / two);
    tested({t, from.mid - both, bottom}, nearest);
    return nearest.point;
  }
};

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
