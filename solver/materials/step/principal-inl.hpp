// Principal stresses of a vector of points, in order and back; once for each instruction set.

#if defined(LEDA_SOLVER_PRINCIPAL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_PRINCIPAL_INL
#undef LEDA_SOLVER_PRINCIPAL_INL
#else
#define LEDA_SOLVER_PRINCIPAL_INL
#endif

#include "hwy/highway.h"
#include "solver/materials/step/tensor-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Principal stresses of a plane strain stress: `in_high` >= `in_low` in the plane, and the
/// largest and the smallest of all three.
template <class D>
struct Principal {
  hn::Vec<D> in_high, in_low, apart, radius;  ///< apart = (xx - zz) / 2
  hn::Vec<D> high, low;
  hn::Vec<D> across;  ///< the plane: yy
};

template <class D>
HWY_INLINE Principal<D> principal(D d, const PlaneStress<hn::Vec<D>>& s) {
  const auto half = constant(d, 0.5);
  const auto centre = half * (s.xx + s.zz), apart = half * (s.xx - s.zz);
  const auto radius = hn::Sqrt(hn::MulAdd(apart, apart, s.xz * s.xz));
  const auto a = centre + radius, b = centre - radius;
  return {a, b, apart, radius, hn::Max(a, s.yy), hn::Min(b, s.yy), s.yy};
}

/// high >= mid >= low
template <class D>
struct InOrder {
  hn::Vec<D> high, mid, low;
};

/// Which of the three in order is the one across the plane: the largest, the smallest, or neither.
template <class D>
struct Across {
  hn::Mask<D> is_high, is_low;
};

template <class D>
HWY_INLINE Across<D> across(D, const PlaneStress<hn::Vec<D>>& s, const Principal<D>& p) {
  return {hn::Gt(s.yy, p.in_high), hn::Lt(s.yy, p.in_low)};
}

template <class D>
HWY_INLINE InOrder<D> in_order(D, const PlaneStress<hn::Vec<D>>& s, const Principal<D>& p,
                               const Across<D>& a) {
  return {p.high, hn::IfThenElse(a.is_high, p.in_high, hn::IfThenElse(a.is_low, p.in_low, s.yy)),
          p.low};
}

/// The stress with these principal values, in the directions of `trial`.
template <class D>
HWY_INLINE PlaneStress<hn::Vec<D>> in_plane(D d, const InOrder<D>& r, const Across<D>& a,
                                            const Principal<D>& p,
                                            const PlaneStress<hn::Vec<D>>& trial) {
  const auto half = constant(d, 0.5);
  const auto in_high = hn::IfThenElse(a.is_high, r.mid, r.high);
  const auto in_low = hn::IfThenElse(a.is_low, r.mid, r.low);
  const auto yy = hn::IfThenElse(a.is_high, r.high, hn::IfThenElse(a.is_low, r.low, r.mid));
  const auto centre = half * (in_high + in_low);
  const auto shrink = half * (in_high - in_low) / hn::Max(p.radius, constant(d, tiny<D>));
  return {hn::MulAdd(p.apart, shrink, centre), hn::NegMulAdd(p.apart, shrink, centre),
          trial.xz * shrink, yy};
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
