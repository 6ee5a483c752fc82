#pragma once
// A symmetric matrix whose couplings reach two columns of nodes, and its Cholesky factor.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace leda::solver {

/// Lower half, by columns of nodes: dense blocks on the diagonal and one and two columns below.
/// A section is long and low, so this order fills no more than a general sparse one (AMD on
/// Sainte-Monique: 7.1 million entries, this: 7.8) and runs on dense kernels. In single precision:
/// the factor guides an iteration whose residual is taken in double, so its own error costs
/// nothing but, at worst, a round more.
class ColumnMatrix {
 public:
  using Vector = Eigen::VectorXd;

  /// @param first number of the first unknown of each column, and one past the last
  explicit ColumnMatrix(const std::vector<std::int32_t>& first);

  /// Bytes the blocks of such a matrix take.
  static double bytes(const std::vector<std::int32_t>& first);

  /// Adds to the entry of two unknowns; of a pair only the order row >= column is kept.
  void add(std::int32_t row, std::int32_t column, double value);

  /// Puts the Cholesky factor in the matrix's place.
  /// @return false where it is not positive definite; the matrix is lost then
  bool factorize();

  /// Solves in place. @pre factorize() was true
  void solve(Vector& solution) const;

 private:
  using Block = Eigen::Map<Eigen::MatrixXf>;
  using ConstBlock = Eigen::Map<const Eigen::MatrixXf>;

  std::size_t columns() const { return first_.size() - 1; }
  Eigen::Index size(std::size_t c) const { return first_[c + 1] - first_[c]; }
  Block block(std::size_t row, std::size_t column);
  ConstBlock block(std::size_t row, std::size_t column) const;

  std::vector<std::int32_t> first_;
  std::vector<std::int32_t> column_of_;  // unknown to column
  std::vector<std::size_t> start_;       // [column][0, 1, 2 below the diagonal]
  std::vector<float> value_;
};

}  // namespace leda::solver
