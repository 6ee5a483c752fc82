// Flow part of a law: a viscous stress beyond yield (Bingham, Herschel and Bulkley). The laws as
// scalar functions with their sources: solver/materials/rate/.

#if defined(LEDA_SOLVER_FLOW_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_FLOW_INL
#undef LEDA_SOLVER_FLOW_INL
#else
#define LEDA_SOLVER_FLOW_INL
#endif

#include "hwy/contrib/math/math-inl.h"
#include "hwy/highway.h"
#include "solver/materials/laws.hpp"
#include "solver/materials/step/law_rows-inl.hpp"
#include "solver/materials/step/tensor-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Stress falls back to the yield surface at once.
struct NoFlow {
  static constexpr bool flows = false;
};

struct ViscousFlow {
  static constexpr bool flows = true;

  /// Plastic shear strain x of a step that starts `excess` beyond yield: G x + eta (x / dt)^n =
  /// excess, Pa. The flow is implicit, so no viscosity limits the time step.
  ///
  /// With u = ln(G x / excess) this is e^u + k e^(n u) = 1: convex and rising, so Newton falls onto
  /// the root from above, min(0, -ln k / n), without a safeguard. Seven rounds leave less than 1e-9
  /// of excess for n of 0.1 to 3 in double precision (tests/solver/materials).
  template <class D, class Laws>
  static HWY_INLINE hn::Vec<D> strain(D d, const LawRows<D>& row, const Laws& laws,
                                      hn::Vec<D> excess, hn::Vec<D> g, hn::Vec<D> dt) {
    const auto least = constant(d, tiny<D>), lowest = constant(d, no_exponent<D>);
    const auto one = constant(d, 1);
    const auto n = row(laws.viscous.flow_exponent);
    const auto positive = hn::Max(excess, least);
    const auto elastic = positive / g;  // the strain without viscosity
    const auto eta = hn::Log(d, hn::Max(row(laws.viscous.consistency), least));
    const auto rate = hn::Log(d, hn::Max(elastic / dt, least));
    const auto log_k = hn::MulAdd(n, rate, eta - hn::Log(d, positive));
    auto u = hn::Min(hn::Zero(d), hn::Neg(log_k / n));
    for (int i = 0; i < 7; ++i) {
      const auto plastic = hn::Exp(d, hn::Max(u, lowest));
      const auto viscous = hn::Exp(d, hn::Max(hn::MulAdd(n, u, log_k), lowest));
      u = u - (plastic + viscous - one) / hn::MulAdd(n, viscous, plastic);
    }
    return hn::Exp(d, hn::Max(u, lowest)) * elastic;
  }
};

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
