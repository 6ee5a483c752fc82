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

/// Strength does not depend on the rate of shear.
struct NoRate {
  static constexpr bool depends = false;
};

/// The rate acts on the strength above the remolded one, which was measured slowly; the remolded
/// strength, measured fast (fall cone, vane), has a law of its own or none:
///
///   s = s_ur f_r(rate) + (s - s_ur) f(rate)
struct FactorRate {
  static constexpr bool depends = true;

  /// @param s strength at the laboratory's rate, Pa  @param rate engineering shear rate, 1/s
  template <class D, class Laws>
  static HWY_INLINE hn::Vec<D> strength(D d, const LawRows<D>& row, const Laws& laws, hn::Vec<D> s,
                                        hn::Vec<D> rate) {
    const auto& v = laws.viscous;
    const auto remolded = hn::Min(row(v.remolded), s);
    const auto above = (s - remolded) * factor(d, row, v.rate, rate);
    if (!v.remolded_rate.depends) return remolded + above;
    return hn::MulAdd(remolded, factor(d, row, v.remolded_rate, rate), above);
  }

 private:
  /// All three laws are one formula, r = max(least, rate / reference):
  /// factor = base + log_share ln r + power_share r^exponent, never below 1.
  template <class D, class Rows>
  static HWY_INLINE hn::Vec<D> factor(D d, const LawRows<D>& row, const Rows& v, hn::Vec<D> rate) {
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
