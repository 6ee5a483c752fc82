// Softening part of a law: strength over plastic strain, in the one form that every softening law
// takes (solver/materials/softening_curve.hpp).

#if defined(LEDA_SOLVER_SOFTENING_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_SOFTENING_INL
#undef LEDA_SOLVER_SOFTENING_INL
#else
#define LEDA_SOLVER_SOFTENING_INL
#endif

#include "hwy/contrib/math/math-inl.h"
#include "hwy/highway.h"
#include "solver/materials/laws.hpp"
#include "solver/materials/step/law_rows-inl.hpp"
#include "solver/materials/step/tensor-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Ground that keeps its peak strength.
struct NoSoftening {
  static constexpr bool band = false;

  template <class D, class Laws>
  static HWY_INLINE hn::Vec<D> strength(D, const LawRows<D>& row, const Laws& laws, hn::Vec<D>) {
    return row(laws.peak);
  }
};

/// s_u at the start of the step: the peak until the first yield, then the curve at gamma.
struct CurveSoftening {
  static constexpr bool band = false;

  template <class D, class Laws>
  static HWY_INLINE hn::Vec<D> strength(D d, const LawRows<D>& row, const Laws& laws,
                                        hn::Vec<D> gamma) {
    const auto peak = row(laws.peak);
    const auto yielded = hn::Gt(gamma, hn::Zero(d));
    if (HWY_LIKELY(hn::AllFalse(d, yielded))) return peak;
    const auto exponent = hn::Max(hn::Neg(row(laws.rate) * gamma), constant(d, no_exponent<D>));
    auto s = hn::MulAdd(row(laws.amplitude), hn::Exp(d, exponent), row(laws.floor));
    s = hn::Min(s, peak);
    const auto beyond = gamma - row(laws.exp_end);
    const auto line = hn::MulAdd(row(laws.line_slope), beyond, row(laws.line_start));
    s = hn::IfThenElse(hn::Gt(beyond, hn::Zero(d)), line, s);
    s = hn::IfThenElse(hn::Ge(gamma, row(laws.line_end)), row(laws.last), s);
    return hn::IfThenElse(yielded, s, peak);
  }
};

/// The same, gamma being averaged over a band (solver/kernel/band.hpp).
struct BandSoftening : CurveSoftening {
  static constexpr bool band = true;
};

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
