// Means over spans (B-bar) of a vector of points, once for each instruction set. A span is the home
// cell of its points, so what eight lanes give to their spans is a run of memory too.

#if defined(LEDA_SOLVER_SPANS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_SPANS_INL
#undef LEDA_SOLVER_SPANS_INL
#else
#define LEDA_SOLVER_SPANS_INL
#endif

#include "hwy/highway.h"
#include "solver/kernel/spline-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Adds volume, and volume times a value, to the spans from this column and row on.
template <class D>
HWY_INLINE void add_to_spans(D d, Number<D>* span, std::size_t stride, hn::Vec<D> volume,
                             hn::Vec<D> value) {
  add_to_rows(d, volume, span);
  add_to_rows(d, volume * value, span + stride);
}

/// The mean over the spans from this column and row on.
template <class D>
HWY_INLINE hn::Vec<D> span_mean(D d, const Number<D>* span, std::size_t stride) {
  const auto volume = hn::Max(load_rows(d, span), constant(d, tiny<D>));  // empty lanes
  return load_rows(d, span + stride) / volume;
}

/// Mean of the in-plane normal stresses.
template <class D>
HWY_INLINE hn::Vec<D> mean_in_plane(D d, hn::Vec<D> sxx, hn::Vec<D> szz) {
  return constant(d, 0.5) * (sxx + szz);
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
