// Yield part of a law: 3D Tresca, largest minus smallest principal stress <= 2 s.
//
// Returned by closest projection in the elastic metric, mean stress unchanged: main plane, and the
// two corners where the middle principal stress meets the largest or the smallest.
// Source: de Souza Neto, Peric and Owen 2008, 8.2.
//
// A yield part has: limits(), yields(), excess(), and returned(). Another surface is another file
// with the same four.

#if defined(LEDA_SOLVER_TRESCA_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_TRESCA_INL
#undef LEDA_SOLVER_TRESCA_INL
#else
#define LEDA_SOLVER_TRESCA_INL
#endif

#include "hwy/highway.h"
#include "solver/materials/step/elastic-inl.hpp"
#include "solver/materials/step/law_rows-inl.hpp"
#include "solver/materials/step/principal-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
struct Returned {
  PlaneStress<hn::Vec<D>> stress;
  hn::Vec<D> plastic_strain;  ///< engineering shear strain of the return
  hn::Vec<D> opening;         ///< increase of volume by it, of cracks
};

/// Where ground yields, Pa.
template <class D>
struct Limits {
  hn::Vec<D> shear;    ///< shear strength s
  hn::Vec<D> tension;  ///< tensile strength; of surfaces that have one
};

/// Closest point of Tresca's surface; for high - low >= 2 s.
template <class D>
HWY_INLINE InOrder<D> to_tresca(D d, const InOrder<D>& p, hn::Vec<D> s) {
  const auto half = constant(d, 0.5), third = constant(d, 1.0 / 3.0);
  const auto two = s + s, four = two + two;
  const auto excess = hn::Max((p.high - p.low) - two, hn::Zero(d));
  const auto h1 = hn::NegMulAdd(half, excess, p.high), l1 = hn::MulAdd(half, excess, p.low);
  const auto sum = p.high + p.mid + p.low;
  const auto top = hn::Gt(p.mid, h1), bottom = hn::Lt(p.mid, l1);  // never both
  const auto top_high = third * (sum + two), top_low = third * (sum - four);
  const auto bottom_high = third * (sum + four), bottom_low = third * (sum - two);
  return {hn::IfThenElse(top, top_high, hn::IfThenElse(bottom, bottom_high, h1)),
          hn::IfThenElse(top, top_high, hn::IfThenElse(bottom, bottom_low, p.mid)),
          hn::IfThenElse(top, top_low, hn::IfThenElse(bottom, bottom_low, l1))};
}

struct Tresca {
  /// @param s shear strength at the laboratory's rate
  template <class D, class Laws>
  static HWY_INLINE Limits<D> limits(D d, const LawRows<D>&, const Laws&, const Principal<D>&,
                                     hn::Vec<D> s) {
    return {s, hn::Zero(d)};
  }

  /// Lanes that are beyond the surface.
  template <class D>
  static HWY_INLINE hn::Mask<D> yields(D, const Principal<D>& p, const Limits<D>& limit) {
    return hn::Gt(p.high - p.low, limit.shear + limit.shear);
  }

  /// Shear stress beyond the surface, Pa; negative within.
  template <class D>
  static HWY_INLINE hn::Vec<D> excess(D d, const Principal<D>& p, const Limits<D>& limit) {
    return hn::MulSub(constant(d, 0.5), p.high - p.low, limit.shear);
  }

  /// Back to the surface; meaningful in lanes that yield.
  template <class D>
  static HWY_INLINE Returned<D> returned(D d, const PlaneStress<hn::Vec<D>>& trial,
                                         const Principal<D>& p, const Limits<D>& limit,
                                         const Moduli<hn::Vec<D>>& moduli) {
    const auto a = across(d, trial, p);
    const auto from = in_order(d, trial, p, a);
    const auto to = to_tresca(d, from, limit.shear);
    const auto dh = from.high - to.high, dm = from.mid - to.mid, dl = from.low - to.low;
    const auto square = hn::MulAdd(dh, dh, hn::MulAdd(dm, dm, dl * dl));
    // gamma = sqrt(2 e:e) with e = ds / (2 G): the engineering strain in simple shear.
    return {in_plane(d, to, a, p, trial), hn::Sqrt(constant(d, 0.5) * square) / moduli.shear,
            hn::Zero(d)};
  }
};

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
