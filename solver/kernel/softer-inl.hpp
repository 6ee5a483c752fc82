// Lower moduli where ground would limit the time step of the whole model, once for each instruction
// set.

#if defined(LEDA_SOLVER_SOFTER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_SOFTER_INL
#undef LEDA_SOLVER_SOFTER_INL
#else
#define LEDA_SOLVER_SOFTER_INL
#endif

#include "hwy/highway.h"
#include "solver/kernel/spline-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Share of the moduli that points keep. Strength, stress and mass stay what they are.
///
/// Thin ground: a point that light nodes see has a higher frequency than ground as a whole. Where
/// it sees less than 0.8 of a full cell, f = sum w m_i V / (m h^2) with its own density m / V, its
/// moduli are multiplied by (f / 0.8)^2, at least a quarter. So a corner allows 1.07 h / c_p as a
/// flat surface does, instead of 0.69, and a point alone in its cell more, instead of 0.59.
/// Strained ground: points of ground that has flowed no longer stand in an even pattern; rows of
/// points on borders of splines double the frequency. Moduli are multiplied by 1 - 0.35 min(gamma,
/// 1).
/// @param seen sum of w m_i over the nodes, kg/m  @param area h^2, m2  @param gamma plastic strain
template <class D>
HWY_INLINE hn::Vec<D> softer_share(D d, hn::Vec<D> seen, hn::Vec<D> mass, hn::Vec<D> volume,
                                   hn::Vec<D> gamma, Number<D> area) {
  const auto one = constant(d, 1);
  const auto enough = mass * (constant(d, 0.8) * hn::Set(d, area));
  const auto fill = seen * volume / hn::Max(enough, constant(d, 1e-30));  // empty lanes
  const auto thin = hn::Min(hn::Max(fill * fill, constant(d, 0.25)), one);
  const auto strained = hn::NegMulAdd(constant(d, 0.35), hn::Min(gamma, one), one);
  return thin * strained;
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
