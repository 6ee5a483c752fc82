// Strength of ground that drains: Mohr and Coulomb over the effective stress, c' and phi', without
// dilation,
//
//   (high - low) / 2 <= c' cos(phi') - ((high + low) / 2 + u) sin(phi'),   largest + u <= T
//
// u: pore pressure of the water table, tension positive. Without dilation the return keeps the mean
// stress, as Tresca's does, so ground of this kind is Tresca's with the strength s at the place it
// is returned to: the formulas below solve for it on the face, on both edges, and where the cut-off
// of tension meets the surface. Source: Clausen, Damkilde and Andersen 2006 (regions of the return
// to Mohr and Coulomb in principal stresses); Rankine's cut-off: tension-inl.hpp.

#if defined(LEDA_SOLVER_MOHR_COULOMB_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_MOHR_COULOMB_INL
#undef LEDA_SOLVER_MOHR_COULOMB_INL
#else
#define LEDA_SOLVER_MOHR_COULOMB_INL
#endif

#include "hwy/highway.h"
#include "solver/materials/step/tresca-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// What a point of ground that drains is held by.
template <class D>
struct Friction {
  hn::Vec<D> cohesion;  ///< c' cos(phi'), Pa
  hn::Vec<D> sin;       ///< sin(phi')
  hn::Vec<D> pore;      ///< u, Pa
  hn::Vec<D> tension;   ///< T - u, Pa
};

/// The strength s of Tresca's surface that returns a stress to that of Mohr and Coulomb; for a
/// stress within, what it may reach.
template <class D>
HWY_INLINE hn::Vec<D> friction_strength(D d, const Principal<D>& p, const Friction<D>& f) {
  const auto half = constant(d, 0.5), three = constant(d, 3), zero = hn::Zero(d);
  const auto centre = half * (p.high + p.low);
  const auto face = hn::Max(hn::NegMulAdd(centre + f.pore, f.sin, f.cohesion), zero);
  const auto mid = (p.in_high + p.in_low + p.across) - (p.high + p.low);
  const auto sum = p.high + mid + p.low;
  const auto pull = (sum + f.pore + f.pore) * f.sin, two_c = f.cohesion + f.cohesion;
  // high = mid = a, low = sum - 2 a; and mid = low = b, high = sum - 2 b.
  const auto a = (sum + two_c - pull) / (three - f.sin);
  const auto b = (sum - two_c + pull) / (three + f.sin);
  const auto on_top = hn::Max(half * hn::MulSub(three, a, sum), zero);
  const auto on_bottom = hn::Max(half * hn::NegMulAdd(three, b, sum), zero);
  const auto beyond = hn::Gt(p.high - p.low, face + face);
  const auto top = hn::And(beyond, hn::Gt(mid, centre + face));
  const auto bottom = hn::And(beyond, hn::Lt(mid, centre - face));
  const auto s = hn::IfThenElse(top, on_top, hn::IfThenElse(bottom, on_bottom, face));
  // Where the cut-off holds, high is T - u.
  const auto mean = constant(d, 1.0 / 3.0) * sum;
  const auto to_edge = constant(d, 2.0 / 3.0) * s;
  const auto returned = hn::IfThenElse(
      top, mean + to_edge, hn::IfThenElse(bottom, mean + to_edge + to_edge, centre + face));
  const auto high = hn::IfThenElse(beyond, returned, p.high);
  const auto cut = hn::NegMulAdd(f.tension + f.pore, f.sin, f.cohesion) / (constant(d, 1) - f.sin);
  return hn::IfThenElse(hn::Gt(high, f.tension), hn::Max(cut, zero), s);
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
