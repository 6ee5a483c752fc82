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

/// Reads one column of the law table: within a vector where the whole column is one, a broadcast
/// where all lanes share the row.
template <class D>
struct LawRows {
  D d;
  hn::Vec<hn::RebindToSigned<D>> rows;
  std::size_t first;
  bool one_vector;
  bool same;

  HWY_INLINE hn::Vec<D> operator()(const std::vector<hn::TFromD<D>>& column) const {
    if (one_vector) {
      return hn::TableLookupLanes(hn::LoadU(d, column.data()), hn::IndicesFromVec(d, rows));
    }
    if (HWY_LIKELY(same)) return hn::Set(d, column[first]);
    return hn::GatherIndex(d, column.data(), rows);
  }
};

/// @param one_vector whether every column is a vector long and no row is beyond it
template <class D>
HWY_INLINE LawRows<D> law_rows(D d, const std::int32_t* law, bool one_vector = false) {
  using Rows = hn::RebindToSigned<D>;
  hn::Vec<Rows> rows;
  if constexpr (sizeof(hn::TFromD<D>) == sizeof(std::int32_t)) {
    rows = hn::LoadU(Rows(), law);
  } else {
    rows = hn::PromoteTo(Rows(), hn::LoadU(hn::Rebind<std::int32_t, D>(), law));
  }
  const bool same = hn::AllTrue(Rows(), hn::Eq(rows, hn::Set(Rows(), law[0])));
  return {d, rows, static_cast<std::size_t>(law[0]), one_vector, same};
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
