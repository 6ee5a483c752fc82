#pragma once
// Inputs that go together: Spearman's rank correlations by a Gaussian copula, r = 2 sin(pi rho /
// 6).

#include <cstddef>
#include <optional>
#include <vector>

namespace leda::solver {

struct RankCorrelation {
  std::size_t first = 0, second = 0;  ///< indices of inputs
  double rho = 0;                     ///< within (-1, 1)
};

/// Makes independent coordinates of the unit cube correlated, one after the other: the first stays
/// as it is, each later one takes what it has in common with those before it. Immutable.
class Copula {
 public:
  /// @return nothing where no inputs can be correlated so: the matrix is not positive definite
  static std::optional<Copula> make(std::size_t inputs,
                                    const std::vector<RankCorrelation>& correlations);

  /// @param u one coordinate an input, each within (0, 1)
  std::vector<double> operator()(const std::vector<double>& u) const;

 private:
  Copula() = default;
  std::size_t inputs_ = 0;
  std::vector<double> factor_;  ///< Cholesky's, row by row; empty: nothing is correlated
};

}  // namespace leda::solver
