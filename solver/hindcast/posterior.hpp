#pragma once
// The weights of members by what was observed at all slides, or at all but one.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "solver/ensemble/outcome.hpp"
#include "solver/hindcast/observation.hpp"
#include "solver/hindcast/shared_draws.hpp"

namespace leda::solver {

struct HindcastPlan {
  SharedPlan draws;
  std::vector<PastSlide> slides;  ///< at least one
  Discrepancy discrepancy;
  std::size_t waves = 2;        ///< at most
  double least_effective = 32;  ///< members; with fewer, the likelihood is tempered
  double confidence = 0.9;      ///< of predictions and of the inputs' intervals
};

/// By slide, member (of all waves, numbered through) and local draw, as many as were run. A run
/// without a result is an outcome without a status.
using SlideOutcomes = std::vector<std::vector<std::vector<MemberOutcome>>>;

/// Weights of members and what they carry.
struct Weights {
  std::vector<double> values;  ///< one a member, adding up to 1; all 0 where no member agrees
  double effective = 0;        ///< members
  std::optional<double> pareto_k;
};

Weights weights_of(const std::vector<double>& logs);

/// Likelihoods of members at each slide: of the mean over the local draws that slid. Of a member
/// that did not slide in any, or gave no result, the likelihood is 0.
class Likelihoods {
 public:
  Likelihoods(const HindcastPlan& plan, const SlideOutcomes& outcomes);

  /// ln, one a member, over all slides but one, averaged over the discrepancy's bias.
  std::vector<double> of_members(std::optional<std::size_t> without = {}) const;

  /// Values of the bias with the weights that the slides give them for a member.
  struct BiasNode {
    double ln = 0, weight = 0;
  };
  std::vector<BiasNode> bias_of(std::size_t member, std::optional<std::size_t> without = {}) const;

 private:
  std::vector<double> over_nodes(std::size_t member, std::optional<std::size_t> without) const;

  std::vector<BiasNode> nodes_;                            ///< of the prior
  std::vector<std::vector<std::vector<double>>> by_node_;  ///< ln, by slide, member and node
};

/// Weights that the next wave is drawn about: tempered until a sixth of a wave's members count, so
/// that a few waves get far; what a wave is drawn from costs nothing but runs. Nothing where enough
/// members count already, the waves are spent, or no member agrees with all slides.
std::optional<std::vector<double>> next_wave(const HindcastPlan& plan, const SharedDraws& draws,
                                             const SlideOutcomes& outcomes);

}  // namespace leda::solver
