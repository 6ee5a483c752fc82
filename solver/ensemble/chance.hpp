#pragma once
// How much of the scatter is chance (another seed of the same member) and how much the cell moves
// a member (its finer pair).

#include <cstddef>
#include <optional>
#include <vector>

namespace leda::solver {

/// Members with the same inputs and other seeds.
struct ChanceShare {
  std::size_t members = 0, runs = 0;
  double sd_m = 0;              ///< over the seeds of a member, pooled
  std::optional<double> share;  ///< of the variance over all members; absent where that is 0
};

/// @param repeats the distances of each member over its seeds; those with a single one say nothing
/// @param all distances of all members, one a member
/// @return nothing where no member has two
std::optional<ChanceShare> chance_share(const std::vector<std::vector<double>>& repeats,
                                        const std::vector<double>& all);

struct CellPair {
  double coarse_m = 0, fine_m = 0;
};

/// What a finer cell does to the same members. It is a bias: more members do not lessen it.
struct CellShift {
  std::size_t pairs = 0;
  double mean_m = 0;  ///< finer minus coarser
  std::optional<double> standard_error_m;
  std::size_t both_slid = 0;            ///< pairs that the ratio is taken over
  std::optional<double> mean_ln_ratio;  ///< ln(finer / coarser)
  std::optional<double> standard_error_ln;
  std::size_t only_coarse_slid = 0, only_fine_slid = 0;
};

/// @return nothing without pairs
std::optional<CellShift> cell_shift(const std::vector<CellPair>& pairs);

}  // namespace leda::solver
