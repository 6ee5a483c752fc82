#pragma once
// How far an input moved when the slides were seen.

#include <string>
#include <vector>

namespace leda::solver {

struct CentralInterval {
  double low = 0, median = 0, high = 0;  ///< of an interval with as much on both sides
};

struct InputShift {
  std::size_t input = 0;  ///< of the plan
  CentralInterval prior, posterior;
  double shift = 0;      ///< of the mean, in standard deviations of the prior; by ranks
  double narrowing = 1;  ///< standard deviation over the prior's; by ranks
};

/// Of one shared input. Values are compared as normal scores of their ranks in the prior, so that
/// the shape of a distribution does not matter.
/// @param values one a member
/// @param prior and @param posterior weights that add up to 1
/// @param confidence of the intervals
InputShift shift_of(const std::vector<double>& values, const std::vector<double>& prior,
                    const std::vector<double>& posterior, double confidence);

}  // namespace leda::solver
