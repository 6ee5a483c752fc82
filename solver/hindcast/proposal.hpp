#pragma once
// Where a further wave of members is drawn: about the members that agree best so far.

#include <memory>
#include <vector>

namespace leda::solver {

/// A point of the shared inputs, each coordinate of the unit cube as a quantile of the standard
/// normal distribution: the prior is standard normal in it, and no point lies outside the prior.
using Scores = std::vector<double>;

/// A mixture of normal distributions about weighted members, shrunk towards their mean so that it
/// has their mean and covariance (West 1993; Liu and West 2001). Immutable, safe for several
/// threads.
class Proposal {
 public:
  /// @param weights one a member, adding up to 1
  Proposal(const std::vector<Scores>& members, const std::vector<double>& weights);

  /// @param which within (0, 1): chooses the component
  /// @param normals independent standard normal numbers, one a coordinate
  Scores draw(double which, const Scores& normals) const;
  double log_density(const Scores& point) const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

/// ln of the density of the prior.
double log_standard_normal(const Scores& point);

}  // namespace leda::solver
