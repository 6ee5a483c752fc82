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

/// A column of the law table from `first` on for rows counted from there, looked up within as many
/// vectors as `two` says; what is beyond them is anything.
template <class D>
HWY_INLINE hn::Vec<D> look_up(D d, const hn::TFromD<D>* first, hn::Vec<hn::RebindToSigned<D>> rows,
                              bool two) {
  const hn::RebindToSigned<D> r;
  const auto last = static_cast<hn::TFromD<hn::RebindToSigned<D>>>(hn::Lanes(d) - 1);
  const auto within = hn::IndicesFromVec(d, hn::And(rows, hn::Set(r, last)));
  const auto low = hn::TableLookupLanes(hn::LoadU(d, first), within);
  if (!two) return low;
  const auto high = hn::TableLookupLanes(hn::LoadU(d, first + hn::Lanes(d)), within);
  return hn::IfThenElse(hn::RebindMask(d, hn::Gt(rows, hn::Set(r, last))), high, low);
}

/// Reads one column of the law table for a vector of particles. Rows are made in the order of
/// seeding, upwards in each column of points, so that those of neighbours are near one another and
/// need no gather.
template <class D>
struct LawRows {
  enum class Span { one_row, one_vector, two_vectors, any };

  Span span;
  std::size_t lowest;
  hn::Vec<hn::RebindToSigned<D>> rows;  ///< from the lowest on

  HWY_INLINE hn::Vec<D> operator()(const std::vector<hn::TFromD<D>>& column) const {
    const D d;
    const auto* first = column.data() + lowest;
    if (span == Span::one_row) return hn::Set(d, *first);
    if (span == Span::any) return hn::GatherIndex(d, first, rows);
    return look_up(d, first, rows, span == Span::two_vectors);
  }
};

/// The rows of a vector of particles.
/// @param all rows of the table, whose columns go on for two vectors beyond the last one
template <class D>
HWY_INLINE LawRows<D> law_rows(D d, const std::int32_t* law, std::size_t all) {
  using R = hn::RebindToSigned<D>;
  using Span = typename LawRows<D>::Span;
  const R r;
  hn::Vec<R> rows;
  if constexpr (sizeof(hn::TFromD<D>) == sizeof(std::int32_t)) {
    rows = hn::LoadU(r, law);
  } else {
    rows = hn::PromoteTo(r, hn::LoadU(hn::Rebind<std::int32_t, D>(), law));
  }
  if (all <= hn::Lanes(d)) return {Span::one_vector, 0, rows};
  const auto lowest = hn::MinOfLanes(r, rows);
  const auto first = static_cast<std::size_t>(hn::GetLane(lowest));
  rows = hn::Sub(rows, lowest);
  const auto within = [&](std::size_t count) {
    return hn::AllTrue(r, hn::Lt(rows, hn::Set(r, static_cast<hn::TFromD<R>>(count))));
  };
  if (within(1)) return {Span::one_row, first, rows};
  if (!within(2 * hn::Lanes(d))) return {Span::any, first, rows};
  return {within(hn::Lanes(d)) ? Span::one_vector : Span::two_vectors, first, rows};
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
