#pragma once
// What past slides teach: shared inputs after they were seen, each slide predicted from the others,
// and whether the weights can be trusted. Everything is conditional on a slide having started: an
// inventory holds slides alone and says nothing of how probable one is.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "solver/hindcast/coverage.hpp"
#include "solver/hindcast/posterior.hpp"
#include "solver/hindcast/prediction.hpp"
#include "solver/hindcast/shared_shift.hpp"

namespace leda::solver {

/// Over the slides that are predicted.
struct DistanceScore {
  Coverage coverage;  ///< of what was measured
  /// Median of the intervals' upper end over the lower one; absent: infinite.
  std::optional<double> sharpness;
  std::optional<double> mean_crps_ln;
  std::optional<double> mean_crps_of_rule_ln;  ///< absent where it is of any slide
};

struct HindcastSummary {
  std::size_t members = 0, waves = 0;
  double exponent = 1;   ///< of the likelihood in all weights; below 1: tempered
  Weights prior;         ///< by which members of all waves stand for the prior
  Weights full;          ///< with the whole likelihood
  Weights posterior;     ///< with the exponent
  double cut_short = 0;  ///< share of the posterior on members with an observed distance cut short
  double bias_ln = 0, bias_sd_ln = 0;  ///< of the discrepancy, posterior
  std::vector<InputShift> inputs;      ///< those that are shared
  std::vector<SlidePrediction> slides;
  std::map<Distance, DistanceScore> scores;  ///< of what was observed
  std::vector<std::string> doubts;           ///< why the weights can't be trusted; empty: they can
};

/// @pre outcomes of every run of every wave drawn
HindcastSummary summarize(const HindcastPlan& plan, const SharedDraws& draws,
                          const SlideOutcomes& outcomes);

}  // namespace leda::solver
