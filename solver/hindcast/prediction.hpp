#pragma once
// A past slide predicted from the others, without a new run: its factor is left out of the weights.

#include <map>
#include <optional>
#include <string>

#include "solver/hindcast/posterior.hpp"

namespace leda::solver {

/// One distance of a slide as the other slides predict it, discrepancy and survey included.
struct Prediction {
  double low_m = 0, median_m = 0;  ///< members that were cut short counted at their bounds
  std::optional<double> high_m;    ///< absent: members that were cut short know no upper end
  double beyond = 0;               ///< share of the weight on members that were cut short
  double width_ln = 0;             ///< of the interval, infinite where it has no upper end
  std::optional<bool> hit;         ///< what was measured lies in it; absent: bounds alone
  /// Of what was measured: probability of less, and the continuous ranked probability score, ln.
  std::optional<double> pit, crps_ln;
  /// The score of a plain rule: lognormal, by the values measured at the other slides. Absent where
  /// those are fewer than 3 or the same.
  std::optional<double> crps_of_rule_ln;
};

struct SlidePrediction {
  std::map<std::string, std::size_t> runs;  ///< "slid", "cut-short", "at-rest", "no-result"
  /// Share of the runs that slid, under the prior and under the weights of the other slides;
  /// members that were drawn again where they stood count each of their runs.
  double slides_prior = 0, slides_from_others = 0;
  Weights others;                              ///< of members, by the other slides
  std::map<Distance, Prediction> by_distance;  ///< what was observed; empty where no member counts
};

/// @param log_prior of members
/// @param exponent of the likelihood
SlidePrediction predict(const HindcastPlan& plan, const SlideOutcomes& outcomes,
                        const Likelihoods& likelihoods, const std::vector<double>& log_prior,
                        double exponent, std::size_t slide);

/// What was observed of a distance; nullptr: nothing.
const Observed* observed_of(const PastSlide& slide, Distance distance);

}  // namespace leda::solver
