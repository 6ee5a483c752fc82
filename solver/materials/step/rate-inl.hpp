// Rate part of a law: what the strength is multiplied with at a shear rate. The laws themselves, as
// scalar functions with their sources: solver/materials/rate/.

#if defined(LEDA_SOLVER_RATE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_RATE_INL
#undef LEDA_SOLVER_RATE_INL
#else
#define LEDA_SOLVER_RATE_INL
#endif

#include "hwy/contrib/math/math-inl.h"
#include "hwy/highway.h"
#include "solver/materials/laws.hpp"
#include "solver/materials/step/law_rows-inl.hpp"
#include "solver/materials/step/tensor-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Strength does not depend on the rate.
struct NoRate {
  static constexpr bool depends = false;
};

/// All three laws are one formula, r = max(least, rate / reference):
/// factor = base + log_share ln r + power_share r^exponent, never below 1.
struct FactorRate {
  static constexpr bool depends = true;

  /// @param rate engineering shear rate, 1/s
  template <class D, class Laws>
  static HWY_INLINE hn::Vec<D> factor(D d, const LawRows<D>& row, const Laws& laws,
                                      hn::Vec<D> rate) {
    const auto& v = laws.viscous;
    const auto relative = hn::Max(rate / row(v.reference), row(v.least));
    const auto logarithm = hn::Log(d, relative);
    const auto factor = hn::MulAdd(row(v.log_share), logarithm, row(v.base));
    const auto share = row(v.power_share);
    if (hn::AllTrue(d, hn::Eq(share, hn::Zero(d)))) return factor;
    return hn::MulAdd(share, hn::Exp(d, row(v.exponent) * logarithm), factor);
  }
};

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
