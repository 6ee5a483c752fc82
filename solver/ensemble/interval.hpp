#pragma once
// How sure a share and a quantile of some members are.

#include <cstddef>
#include <optional>
#include <vector>

namespace leda::solver {

struct Interval {
  double low = 0, high = 1;
  double half_width() const { return 0.5 * (high - low); }
};

/// Clopper and Pearson 1934: of a probability, when `hits` of `of` independent members hit.
Interval exact_interval(std::size_t hits, std::size_t of, double confidence);

/// Of a probability, from independent replicates: Student's t over their shares. That members are
/// whole alone scatters a share by 1 / sqrt(12) of a member, and less scatter is not believed.
/// With fewer hits or misses than replicates it is the exact interval, and with one replicate too.
/// @param hits of each replicate
/// @param size members of each replicate
Interval interval_of_replicates(const std::vector<std::size_t>& hits, std::size_t size,
                                double confidence);

/// Ranks, from 1, between whose values a quantile lies: free of any distribution, exact for
/// independent members, on the safe side for repeated values and for nets. A rank of 0 or of one
/// more than there are members says that the members know no such end.
struct RankInterval {
  std::size_t low = 0, high = 0;
};

/// The narrowest interval that holds the level's quantile with at least the confidence.
/// @param level share of the values at or below the quantile, within (0, 1)
RankInterval rank_interval(std::size_t members, double level, double confidence);

}  // namespace leda::solver
