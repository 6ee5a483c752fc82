// Yield part of a law: 3D Tresca, largest minus smallest principal stress <= 2 s.
//
// Returned by closest projection in the elastic metric, mean stress unchanged: main plane, and the
// two corners where the middle principal stress meets the largest or the smallest.
// Source: de Souza Neto, Peric and Owen 2008, 8.2.
//
// A yield part has: principal(), yields(), excess(), and returned(). Another surface is another
// file with the same four.

#if defined(LEDA_SOLVER_TRESCA_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_TRESCA_INL
#undef LEDA_SOLVER_TRESCA_INL
#else
#define LEDA_SOLVER_TRESCA_INL
#endif

#include "hwy/highway.h"
#include "solver/materials/step/elastic-inl.hpp"
#include "solver/materials/step/tensor-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct Tresca {
  /// Principal stresses of a plane strain stress: `in_high` >= `in_low` in the plane, and all three
  /// in order.
  template <class D>
  struct Principal {
    hn::Vec<D> in_high, in_low, apart, radius;  ///< apart = (xx - zz) / 2
    hn::Vec<D> high, low;
  };

  template <class D>
  struct Returned {
    PlaneStress<hn::Vec<D>> stress;
    hn::Vec<D> plastic_strain;  ///< engineering shear strain of the return
  };

  template <class D>
  static HWY_INLINE Principal<D> principal(D d, const PlaneStress<hn::Vec<D>>& s) {
    const auto half = constant(d, 0.5);
    const auto centre = half * (s.xx + s.zz), apart = half * (s.xx - s.zz);
    const auto radius = hn::Sqrt(hn::MulAdd(apart, apart, s.xz * s.xz));
    const auto a = centre + radius, b = centre - radius;
    return {a, b, apart, radius, hn::Max(a, s.yy), hn::Min(b, s.yy)};
  }

  /// Lanes that are beyond the surface of shear strength s.
  template <class D>
  static HWY_INLINE hn::Mask<D> yields(D, const Principal<D>& p, hn::Vec<D> s) {
    return hn::Gt(p.high - p.low, s + s);
  }

  /// Shear stress beyond the surface, Pa; negative within.
  template <class D>
  static HWY_INLINE hn::Vec<D> excess(D d, const Principal<D>& p, hn::Vec<D> s) {
    return hn::MulSub(constant(d, 0.5), p.high - p.low, s);
  }

  /// Back to the surface; meaningful in lanes that yield.
  template <class D>
  static HWY_INLINE Returned<D> returned(D d, const PlaneStress<hn::Vec<D>>& trial,
                                         const Principal<D>& p, hn::Vec<D> s, hn::Vec<D> g) {
    const auto half = constant(d, 0.5);
    const auto yy_high = hn::Gt(trial.yy, p.in_high), yy_low = hn::Lt(trial.yy, p.in_low);
    const auto mid = hn::IfThenElse(yy_high, p.in_high, hn::IfThenElse(yy_low, p.in_low, trial.yy));
    const auto r = in_order(d, p.high, mid, p.low, s);
    const auto dh = p.high - r.high, dm = mid - r.mid, dl = p.low - r.low;
    const auto square = hn::MulAdd(dh, dh, hn::MulAdd(dm, dm, dl * dl));
    const auto in_high = hn::IfThenElse(yy_high, r.mid, r.high);
    const auto in_low = hn::IfThenElse(yy_low, r.mid, r.low);
    const auto yy = hn::IfThenElse(yy_high, r.high, hn::IfThenElse(yy_low, r.low, r.mid));
    const auto centre = half * (in_high + in_low);
    const auto shrink = half * (in_high - in_low) / hn::Max(p.radius, constant(d, tiny<D>));
    return {{hn::MulAdd(p.apart, shrink, centre), hn::NegMulAdd(p.apart, shrink, centre),
             trial.xz * shrink, yy},
            // gamma = sqrt(2 e:e) with e = ds / (2 G): the engineering strain in simple shear.
            hn::Sqrt(half * square) / g};
  }

 private:
  template <class D>
  struct InOrder {
    hn::Vec<D> high, mid, low;
  };

  /// For high >= mid >= low with high - low >= 2 s.
  template <class D>
  static HWY_INLINE InOrder<D> in_order(D d, hn::Vec<D> high, hn::Vec<D> mid, hn::Vec<D> low,
                                        hn::Vec<D> s) {
    const auto half = constant(d, 0.5), third = constant(d, 1.0 / 3.0);
    const auto two = s + s, four = two + two;
    const auto excess = hn::Max((high - low) - two, hn::Zero(d));
    const auto h1 = hn::NegMulAdd(half, excess, high), l1 = hn::MulAdd(half, excess, low);
    const auto sum = high + mid + low;
    const auto top = hn::Gt(mid, h1), bottom = hn::Lt(mid, l1);  // never both
    const auto top_high = third * (sum + two), top_low = third * (sum - four);
    const auto bottom_high = third * (sum + four), bottom_low = third * (sum - two);
    return {hn::IfThenElse(top, top_high, hn::IfThenElse(bottom, bottom_high, h1)),
            hn::IfThenElse(top, top_high, hn::IfThenElse(bottom, bottom_low, mid)),
            hn::IfThenElse(top, top_low, hn::IfThenElse(bottom, bottom_low, l1))};
  }
};

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
