// Stress update of a vector of points: the parts of a law put together at compile time.

#if defined(LEDA_SOLVER_STRESS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_STRESS_INL
#undef LEDA_SOLVER_STRESS_INL
#else
#define LEDA_SOLVER_STRESS_INL
#endif

#include "hwy/highway.h"
#include "solver/materials/step/elastic-inl.hpp"
#include "solver/materials/step/flow-inl.hpp"
#include "solver/materials/step/rate-inl.hpp"
#include "solver/materials/step/softening-inl.hpp"
#include "solver/materials/step/tension-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Which part of each kind a run needs; what no row of its table has is not compiled into its step.
template <class YieldPart, class SofteningPart, class RatePart, class FlowPart>
struct Parts {
  using Yield = YieldPart;
  using Softening = SofteningPart;
  using Rate = RatePart;
  using Flow = FlowPart;
};

/// Calls use(Parts<...>{}) with the parts that these laws need.
template <class Laws, class Use>
HWY_INLINE auto with_parts(const Laws& laws, const Use& use) {
  const auto& v = laws.viscous;
  const auto viscous = [&](auto yield, auto softening) {
    using Y = decltype(yield);
    using S = decltype(softening);
    if (v.flows) return use(Parts<Y, S, FactorRate, ViscousFlow>{});
    return v.rate.depends || v.remolded_rate.depends ? use(Parts<Y, S, FactorRate, NoFlow>{})
                                                     : use(Parts<Y, S, NoRate, NoFlow>{});
  };
  const auto softening = [&](auto yield) {
    if (!laws.softens) return viscous(yield, NoSoftening{});
    return laws.band ? viscous(yield, BandSoftening{}) : viscous(yield, CurveSoftening{});
  };
  return laws.cracks || laws.drains ? softening(TrescaWithTension{}) : softening(Tresca{});
}

template <class D>
struct StressStep {
  PlaneStress<hn::Vec<D>> stress;
  hn::Vec<D> plastic_strain;  ///< of this step
  hn::Vec<D> opening;         ///< of cracks in this step, of the volume
  hn::Vec<D> work;            ///< of the mid-step stress per volume, Pa
  bool yields;                ///< whether any lane does; else plastic_strain is zero
};

/// Stress after a strain increment `e` and a rotation `spin` in dt seconds, from stress `old` and
/// plastic strain `gamma`, with the moduli given.
template <class P, class D, class Laws>
HWY_INLINE StressStep<D> next_stress(D d, P, const LawRows<D>& row, const Laws& laws,
                                     const PlaneStress<hn::Vec<D>>& old, hn::Vec<D> gamma,
                                     const PlaneStrain<hn::Vec<D>>& e, hn::Vec<D> spin,
                                     hn::Vec<D> dt, const Moduli<hn::Vec<D>>& moduli) {
  using Yield = typename P::Yield;
  const auto trial = elastic_trial(d, old, e, spin, moduli);
  const auto p = principal(d, trial);
  auto limit = Yield::limits(d, row, laws, p, P::Softening::strength(d, row, laws, gamma));
  auto yields = Yield::yields(d, p, limit);
  if constexpr (P::Rate::depends) {  // a factor below 1 there is none: what stands without it
                                     // stands
    if (!hn::AllFalse(d, yields)) {
      const auto rate = hn::Set(d, laws.rate_share) * shear_strain(d, e) / dt;
      limit.shear = P::Rate::strength(d, row, laws, limit.shear, rate);
      yields = Yield::yields(d, p, limit);
    }
  }
  if (hn::AllFalse(d, yields)) {
    return {trial, hn::Zero(d), hn::Zero(d), work(d, old, trial, e), false};
  }
  if constexpr (P::Flow::flows) {  // what is left beyond yield is the viscous stress of this step
    const auto excess = Yield::excess(d, p, limit);
    const auto strain = P::Flow::strain(d, row, laws, excess, moduli.shear, dt);
    const auto flowing = hn::NegMulAdd(moduli.shear, strain, limit.shear + excess);
    limit.shear = hn::IfThenElse(hn::Gt(excess, hn::Zero(d)), flowing, limit.shear);
  }
  const auto back = Yield::returned(d, trial, p, limit, moduli);
  const PlaneStress<hn::Vec<D>> next{hn::IfThenElse(yields, back.stress.xx, trial.xx),
                                     hn::IfThenElse(yields, back.stress.zz, trial.zz),
                                     hn::IfThenElse(yields, back.stress.xz, trial.xz),
                                     hn::IfThenElse(yields, back.stress.yy, trial.yy)};
  return {next, hn::IfThenElseZero(yields, back.plastic_strain),
          hn::IfThenElseZero(yields, back.opening), work(d, old, next, e), true};
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
