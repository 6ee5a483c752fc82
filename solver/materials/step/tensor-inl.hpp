// Plane strain tensors of a vector of points, once for each instruction set.

#if defined(LEDA_SOLVER_TENSOR_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_TENSOR_INL
#undef LEDA_SOLVER_TENSOR_INL
#else
#define LEDA_SOLVER_TENSOR_INL
#endif

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// In-plane components of a symmetric tensor; xz is the tensor component, not the engineering one.
template <class V>
struct PlaneStrain {
  V xx, zz, xz;
};

/// Cauchy stress, Pa, tension positive; yy is across the section.
template <class V>
struct PlaneStress {
  V xx, zz, xz, yy;
};

/// A constant in the type of the lanes.
template <class D>
HWY_INLINE hn::Vec<D> constant(D d, double value) {
  return hn::Set(d, static_cast<hn::TFromD<D>>(value));
}

/// Where exp is as good as zero and still a normal number.
template <class D>
constexpr double no_exponent = sizeof(hn::TFromD<D>) == 4 ? -80.0 : -700.0;

/// Smaller than any stress, strain or rate that matters, and its square still a normal number.
template <class D>
constexpr double tiny = sizeof(hn::TFromD<D>) == 4 ? 1e-18 : 1e-150;

/// Engineering shear strain sqrt(2 e':e') of a plane strain increment.
template <class D>
HWY_INLINE hn::Vec<D> shear_strain(D d, const PlaneStrain<hn::Vec<D>>& e) {
  const auto mean = constant(d, 1.0 / 3.0) * (e.xx + e.zz);
  const auto x = e.xx - mean, z = e.zz - mean;
  const auto normal = hn::MulAdd(x, x, hn::MulAdd(z, z, mean * mean));
  const auto square = hn::MulAdd(e.xz + e.xz, e.xz, normal);
  return hn::Sqrt(square + square);
}

/// Work of the mid-step stress over an increment, per volume, Pa.
template <class D>
HWY_INLINE hn::Vec<D> work(D d, const PlaneStress<hn::Vec<D>>& before,
                           const PlaneStress<hn::Vec<D>>& after, const PlaneStrain<hn::Vec<D>>& e) {
  const auto normal = hn::MulAdd(before.xx + after.xx, e.xx, (before.zz + after.zz) * e.zz);
  const auto shear = (before.xz + after.xz) * (e.xz + e.xz);
  return constant(d, 0.5) * (normal + shear);
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
