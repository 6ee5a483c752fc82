#pragma once
// The members of a hindcast, wave after wave: shared inputs, which are the same at every past
// slide, and local ones, which each slide draws for itself.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "solver/ensemble/draws.hpp"
#include "solver/hindcast/proposal.hpp"

namespace leda::solver {

/// How members are drawn. Inputs whose scope is the region are shared.
struct SharedPlan {
  std::vector<UncertainInput> inputs;
  std::vector<RankCorrelation> correlations;  ///< positive definite
  std::size_t members = 64;                   ///< of a wave
  std::size_t locals = 1;                     ///< draws of local inputs of a member and slide
  std::uint64_t seed = 1;
};

/// One run: a member at a slide, with one draw of the slide's own inputs.
struct HindcastRun {
  std::size_t slide = 0, member = 0, local = 0;
  bool operator==(const HindcastRun&) const = default;
};

/// The first wave is a Latin hypercube of the prior, whose slides are independent of each other. A
/// draw depends on the seed, the wave, slide, member and input alone, and in later waves on the
/// proposals.
class SharedDraws {
 public:
  explicit SharedDraws(SharedPlan plan);

  /// Draws a further wave. @param weights of the members so far, adding up to 1
  void add_wave(const std::vector<double>& weights);

  std::size_t waves() const { return waves_.size(); }
  std::size_t members() const { return scores_.size(); }  ///< of all waves, numbered through

  /// ln of prior over what all waves together were drawn from, one a member: weights by which
  /// members of all waves stand for the prior (deterministic mixture, Veach and Guibas 1995).
  std::vector<double> log_prior() const;

  /// The value of each input, in the plan's order.
  std::vector<double> inputs_of(const HindcastRun& run, const std::string& slide) const;
  std::uint64_t particle_seed(const HindcastRun& run, const std::string& slide) const;

  const SharedPlan& plan() const { return plan_; }

 private:
  /// One a draw of the local inputs; shared inputs are as in the first.
  using Wave = std::vector<Draws>;
  Wave wave_of(std::size_t wave) const;
  Scores scores_of_first_wave(std::size_t member) const;

  SharedPlan plan_;
  std::vector<std::size_t>
      coordinates_;  ///< inputs that are shared and have a coordinate of their own
  std::vector<Wave> waves_;
  std::vector<Proposal> proposals_;  ///< of the second wave and later ones
  std::vector<Scores> scores_;       ///< by member
};

}  // namespace leda::solver
