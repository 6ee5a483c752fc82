#pragma once
// Which input decides how much, from the members that were run anyway.

#include <cstddef>
#include <optional>
#include <vector>

namespace leda::solver {

struct SobolIndex {
  double first_order = 0;     ///< share of the variance that this input alone explains
  double standard_error = 0;  ///< by leaving out each replicate in turn
};

/// The first-order index as a correlation ratio over bins of ranks (Pearson 1905; Plischke,
/// Borgonovo and Smith 2013): the members sorted by the input in 8 equal bins, 16 from 256 members
/// on; variance between the bins less what chance alone puts there, over the variance of all.
/// Slightly negative values are chance. Neighbours in rank (Gamboa et al. 2022) are no estimate on
/// nets, whose neighbours are no independent ones: README.md, "Indices".
/// @param replicates member m belongs to replicate m % replicates; at least 2
/// @return nothing where y does not vary, or where a bin would have fewer than 2 members
std::optional<SobolIndex> first_order_index(const std::vector<double>& input,
                                            const std::vector<std::optional<double>>& y,
                                            std::size_t replicates);

}  // namespace leda::solver
