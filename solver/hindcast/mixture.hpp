#pragma once
// A distance predicted from members: a mixture of normal distributions of its logarithm, one a
// member, some of them known from below alone.

#include <optional>
#include <vector>

namespace leda::solver {

class Mixture {
 public:
  /// @param ln_distance mean of the component
  /// @param beyond the member was cut short: it may be anywhere above
  void add(double weight, double ln_distance, bool beyond);
  /// Weights are made to add up to 1. @param sd_ln of every component, above 0
  void close(double sd_ln);

  bool empty() const { return parts_.empty(); }
  /// Share of the weight that was cut short.
  double beyond() const { return beyond_; }

  /// Probability of at most this, members that were cut short counted at their bounds.
  double cdf(double ln_distance) const;
  /// @return ln of the distance that is not exceeded with this probability, members cut short at
  ///         their bounds
  double quantile(double probability) const;
  /// The same with members cut short beyond any distance; nothing where the quantile is.
  std::optional<double> quantile_at_most(double probability) const;

  /// Continuous ranked probability score of an observation, ln: the integral over the square of
  /// what the distribution is away from a step there; 0 is best. Members cut short count at their
  /// bounds.
  double crps(double ln_observed) const;

 private:
  struct Part {
    double weight = 0, mean = 0;
    bool beyond = false;
  };
  double cdf_of(double ln_distance, bool bounds_count) const;
  std::optional<double> solve(double probability, bool bounds_count) const;

  std::vector<Part> parts_;
  double sd_ = 1, beyond_ = 0;
};

}  // namespace leda::solver
