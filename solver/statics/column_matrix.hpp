#pragma once
// A symmetric matrix whose couplings reach two columns of nodes, and its Cholesky factor.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "solver/statics/freedoms.hpp"
#include "solver/statics/triangle.hpp"

namespace leda::solver {

/// Two columns of nodes make a pair. By pairs the matrix is block tridiagonal, with A_i on the
/// diagonal and B_i below it:
///     A_i - B_{i-1} A_{i-1}^-1 B_{i-1}^T = L_i L_i^T.
/// Kept are the triangles L_i and, as they are, the few entries of B_i: L_{i+1,i} = B_i L_i^-T
/// would be dense. A section is long and low, so this order needs less memory than a general sparse
/// factor (Sainte-Monique at 1 m: 7.1 million entries with AMD's order) and runs on dense kernels.
/// In single precision: the factor guides an iteration whose residual is taken in double, so its
/// own error costs nothing but, at worst, a round more.
class ColumnMatrix {
 public:
  using Vector = Eigen::VectorXd;

  explicit ColumnMatrix(const Freedoms& freedoms);

  /// Bytes such a matrix takes.
  static double bytes(const Freedoms& freedoms);

  /// Adds to the entry of two unknowns, whose nodes are at most two columns and two rows apart; of
  /// a pair of unknowns only the order row >= column is kept.
  void add(std::int32_t row, std::int32_t column, double value);

  /// Puts the Cholesky factor in the matrix's place.
  /// @return false where it is not positive definite; the matrix is lost then
  bool factorize();

  /// Solves in place. @pre factorize() was true
  void solve(Vector& solution) const;

 private:
  using Index = Eigen::Index;
  // An unknown is coupled to those of five nodes of a column, which are numbered one after the
  // other.
  static constexpr int run = 10;
  using Run = Eigen::Matrix<float, run, 1>;

  std::size_t pairs() const { return triangle_at_.size() - 1; }
  // Of a pair: its first unknown, that of its second column, and one past its last.
  std::int32_t begin(std::size_t pair) const { return first_[2 * pair]; }
  std::int32_t middle(std::size_t pair) const { return first_[2 * pair + 1]; }
  std::int32_t end(std::size_t pair) const { return first_[2 * pair + 2]; }
  Triangle triangle(std::size_t pair);
  ConstTriangle triangle(std::size_t pair) const;
  std::size_t run_of(std::size_t pair, std::int32_t unknown, std::size_t apart) const;
  Eigen::Map<const Run> run_values(std::size_t at) const;
  // visit(unknown, number of the run); those of the last pair reach nowhere.
  template <class Visit>
  void for_each_run(std::size_t pair, const Visit& visit) const;
  void take_from_next(std::size_t pair);

  std::vector<std::int32_t> first_;       // of an even number of columns, and one past the last
  std::vector<std::int32_t> column_of_;   // unknown to column
  std::vector<std::size_t> triangle_at_;  // [pairs + 1]
  std::vector<float> triangles_;
  // Runs of a pair: one of each unknown of its first column, into the first of the next pair; two
  // of each of its second, into both.
  std::vector<std::size_t> runs_at_;     // [pairs + 1]
  std::vector<std::int32_t> run_begin_;  // [runs] first unknown of a run
  std::vector<float> runs_;              // [runs][run]
};

}  // namespace leda::solver
