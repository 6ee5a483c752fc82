#pragma once
// How often intervals held what was observed, beside how often chance would have it so.

#include <cstddef>

namespace leda::solver {

struct Coverage {
  std::size_t hits = 0, of = 0;
  /// Probability of so few hits or fewer, were the intervals right. A few events only show gross
  /// failure: a large one proves nothing.
  double chance = 1;
};

/// @param confidence of the intervals, within (0, 1)
Coverage coverage(std::size_t hits, std::size_t of, double confidence);

}  // namespace leda::solver
