// Rate and flow laws of a vector of particles, once for each instruction set. The laws themselves,
// as scalar functions with their sources: solver/materials/rate/.

#if defined(LEDA_SOLVER_VISCOUS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_VISCOUS_INL
#undef LEDA_SOLVER_VISCOUS_INL
#else
#define LEDA_SOLVER_VISCOUS_INL
#endif

#include "hwy/contrib/math/math-inl.h"
#include "hwy/highway.h"
#include "solver/materials/law_rows-inl.hpp"
#include "solver/materials/law_table.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// What the strength is multiplied with at an engineering shear rate, 1/s.
template <class D>
HWY_INLINE hn::Vec<D> rate_factor(D d, const LawRows<D>& row, const ViscousLaws& laws,
                                  hn::Vec<D> rate) {
  const auto relative = hn::Max(hn::Div(rate, row(laws.reference)), row(laws.least));
  const auto logarithm = hn::Log(d, relative);
  const auto factor = hn::MulAdd(row(laws.log_share), logarithm, row(laws.base));
  const auto power = hn::Exp(d, hn::Mul(row(laws.exponent), logarithm));
  return hn::MulAdd(row(laws.power_share), power, factor);
}

/// Plastic shear strain x of a step that starts `excess` beyond yield: G x + eta (x / dt)^n =
/// excess, Pa. The flow is implicit, so no viscosity limits the time step.
///
/// With u = ln(G x / excess) this is e^u + k e^(n u) = 1: convex and rising, so Newton falls onto
/// the root from above, min(0, -ln k / n), without a safeguard. Seven rounds leave less than 1e-9
/// of excess for n of 0.1 to 3 (tests/solver/viscous_test.cpp).
template <class D>
HWY_INLINE hn::Vec<D> flow_strain(D d, const LawRows<D>& row, const ViscousLaws& laws,
                                  hn::Vec<D> excess, hn::Vec<D> g, hn::Vec<D> dt) {
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0), tiny = hn::Set(d, 1e-200);
  const auto n = row(laws.flow_exponent);
  const auto positive = hn::Max(excess, tiny);
  const auto elastic = hn::Div(positive, g);  // the strain without viscosity
  const auto eta = hn::Log(d, hn::Max(row(laws.consistency), tiny));
  const auto rate = hn::Log(d, hn::Div(elastic, dt));
  const auto log_k = hn::MulAdd(n, rate, hn::Sub(eta, hn::Log(d, positive)));
  auto u = hn::Min(zero, hn::Neg(hn::Div(log_k, n)));
  for (int i = 0; i < 7; ++i) {
    const auto plastic = hn::Exp(d, hn::Max(u, hn::Set(d, -700.0)));
    const auto viscous = hn::Exp(d, hn::Max(hn::MulAdd(n, u, log_k), hn::Set(d, -700.0)));
    const auto rest = hn::Sub(hn::Add(plastic, viscous), one);
    u = hn::Sub(u, hn::Div(rest, hn::MulAdd(n, viscous, plastic)));
  }
  return hn::Mul(hn::Exp(d, hn::Max(u, hn::Set(d, -700.0))), elastic);
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
