#pragma once
// What was seen of a past slide, and how far a model that has the right inputs is still from it.

#include <optional>
#include <string>

namespace leda::solver {

/// A distance that was observed: its value with the survey's error, or bounds.
struct Observed {
  std::optional<double> value_m;  ///< above 0; absent: bounds alone
  double sd_ln = 0;               ///< of the survey, of the natural logarithm of the value
  std::optional<double> at_least_m, at_most_m;
};

/// ln(observed) = ln(model) + b + delta + survey. delta is normal with `sd_ln`, independent from
/// event to event, its retrogression and runout of one event correlated. b is the same for all
/// events and both distances, normal around 0; without a spread it is 0.
struct Discrepancy {
  double sd_ln = 0.3;        ///< above 0
  double correlation = 0.5;  ///< from 0, below 1
  double bias_sd_ln = 0;
};

/// A past slide. At least one distance was observed.
struct PastSlide {
  std::string name;
  std::optional<Observed> retrogression, runout;
  /// A distance is not known better than that, m: shorter ones of members that slid count as long.
  double least_m = 1;
};

}  // namespace leda::solver
