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
namespace leda::solver {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Reads one column of the law table: a broadcast where all lanes share the row.
template <class D>
struct LawRows {
  D d;
  hn::Vec<hn::RebindToSigned<D>> rows;
  std::size_t first;
  bool same;

  HWY_INLINE hn::Vec<D> operator()(const std::vector<double>& column) const {
    if (HWY_LIKELY(same)) return hn::Set(d, column[first]);
    return hn::GatherIndex(d, column.data(), rows);
  }
};

template <class D>
HWY_INLINE LawRows<D> law_rows(D d, const std::int32_t* law) {
  const auto rows =
      hn::PromoteTo(hn::RebindToSigned<D>(), hn::LoadU(hn::Rebind<std::int32_t, D>(), law));
  const auto first = hn::Set(hn::RebindToSigned<D>(), law[0]);
  const bool same = hn::AllTrue(hn::RebindToSigned<D>(), hn::Eq(rows, first));
  return {d, rows, static_cast<std::size_t>(law[0]), same};
}

}  // namespace HWY_NAMESPACE
}  // namespace leda::solver
HWY_AFTER_NAMESPACE();

#endif
