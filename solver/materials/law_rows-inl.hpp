// Columns of the law table for a vector of particles, once for each instruction set.

#if defined(LEDA_SOLVER_LAW_ROWS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_LAW_ROWS_INL
#undef LEDA_SOLVER_LAW_ROWS_INL
#else
#define LEDA_SOLVER_LAW_ROWS_INL
#endif

#include <cstdint>
#include <vector>

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Reads one column of the law table: a broadcast where all lanes share the row.
template <class D>
struct LawRows {
  D d;
  hn::Vec<hn::RebindToSigned<D>> rows;
  std::size_t first;
  bool same;

  HWY_INLINE hn::Vec<D> operator()(const std::vector<hn::TFromD<D>>& column) const {
    if (HWY_LIKELY(same)) return hn::Set(d, column[first]);
    return hn::GatherIndex(d, column.data(), rows);
  }
};

template <class D>
HWY_INLINE LawRows<D> law_rows(D d, const std::int32_t* law) {
  using Rows = hn::RebindToSigned<D>;
  hn::Vec<Rows> rows;
  if constexpr (sizeof(hn::TFromD<D>) == sizeof(std::int32_t)) {
    rows = hn::LoadU(Rows(), law);
  } else {
    rows = hn::PromoteTo(Rows(), hn::LoadU(hn::Rebind<std::int32_t, D>(), law));
  }
  const bool same = hn::AllTrue(Rows(), hn::Eq(rows, hn::Set(Rows(), law[0])));
  return {d, rows, static_cast<std::size_t>(law[0]), same};
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
