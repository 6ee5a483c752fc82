// Elastic part of a law: isotropic, linear in the increment, with the Jaumann rate.
//
//   s* = s + w s - s w + (K - 2/3 G) tr(de) 1 + 2 G de,   w = w_xz dt
//
// Source: Sulsky, Chen and Schreyer 1994 for the update in MPM; solver/README.md, "Equations".

#if defined(LEDA_SOLVER_ELASTIC_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_ELASTIC_INL
#undef LEDA_SOLVER_ELASTIC_INL
#else
#define LEDA_SOLVER_ELASTIC_INL
#endif

#include "hwy/highway.h"
#include "solver/materials/step/tensor-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class V>
struct Moduli {
  V bulk, shear;  ///< Pa
};

/// The stress if nothing yields. `spin` = (dvx/dz - dvz/dx) / 2 dt.
template <class D>
HWY_INLINE PlaneStress<hn::Vec<D>> elastic_trial(D d, const PlaneStress<hn::Vec<D>>& old,
                                                 const PlaneStrain<hn::Vec<D>>& e, hn::Vec<D> spin,
                                                 const Moduli<hn::Vec<D>>& moduli) {
  const auto g2 = moduli.shear + moduli.shear;
  const auto lame = hn::NegMulAdd(constant(d, 2.0 / 3.0), moduli.shear, moduli.bulk);
  const auto pressure = lame * (e.xx + e.zz);
  const auto turn = spin + spin;
  return {hn::MulAdd(g2, e.xx, pressure) + hn::MulAdd(turn, old.xz, old.xx),
          hn::MulAdd(g2, e.zz, pressure) + hn::NegMulAdd(turn, old.xz, old.zz),
          hn::MulAdd(g2, e.xz, hn::MulAdd(spin, old.zz - old.xx, old.xz)), old.yy + pressure};
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
