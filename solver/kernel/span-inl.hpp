// Means over the spans of the grid for a vector of particles, once for each instruction set.

#if defined(LEDA_SOLVER_SPAN_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_SPAN_INL
#undef LEDA_SOLVER_SPAN_INL
#else
#define LEDA_SOLVER_SPAN_INL
#endif

#include "hwy/highway.h"
#include "solver/kernel/grid.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Sum `which` (1 pressure, 2 dilation) over volume, of the span whose lowest node is `node`.
template <class D>
HWY_INLINE hn::Vec<D> span_mean(D d, const Grid& grid, hn::Vec<hn::RebindToSigned<D>> node,
                                std::int64_t which) {
  const hn::RebindToSigned<D> whole;
  const auto first = hn::Add(hn::Add(node, node), node);
  const auto sum = hn::GatherIndex(d, grid.span.data(), hn::Add(first, hn::Set(whole, which)));
  return hn::Div(sum, hn::GatherIndex(d, grid.span.data(), first));
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
