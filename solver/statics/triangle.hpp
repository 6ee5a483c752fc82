#pragma once
// A lower triangle in half a square, and its Cholesky factor.

#include <Eigen/Core>
#include <algorithm>
#include <type_traits>

namespace leda::solver {

/// The lower half of a symmetric matrix of n1 + n2 unknowns,
///     [ T1    ]
///     [ S  T2 ]
/// in a rectangle of (n1 + n2 + 1) x max(n1, n2) floats, column by column: T1 one row below the
/// top, S below it, and the transpose of T2 in what is left of the upper rows (rectangular full
/// packed format: Gustavson et al. 2010, ACM Trans. Math. Softw. 37, 18). A view; it owns nothing.
/// @tparam Float float, or const float to read only
template <class Float>
class TriangleView {
 public:
  using Index = Eigen::Index;

  TriangleView(Float* values, Index n1, Index n2)
      : n1_(n1), n2_(n2), all_(values, n1 + n2 + 1, std::max(n1, n2)) {}

  /// T1, of which the lower half counts.
  auto t1() const { return all_.block(1, 0, n1_, n1_); }
  auto t1() { return all_.block(1, 0, n1_, n1_); }
  /// [n2][n1]
  auto s() const { return all_.block(n1_ + 1, 0, n2_, n1_); }
  auto s() { return all_.block(n1_ + 1, 0, n2_, n1_); }
  /// The transpose of T2, of which the upper half counts.
  auto t2_transposed() const { return all_.block(0, 0, n2_, n2_); }
  auto t2_transposed() { return all_.block(0, 0, n2_, n2_); }

  /// The entry of two unknowns, row >= column.
  Float& at(Index row, Index column) {
    if (column >= n1_) return all_(column - n1_, row - n1_);
    return all_(row + 1, column);
  }

 private:
  using Matrix = std::conditional_t<std::is_const_v<Float>, const Eigen::MatrixXf, Eigen::MatrixXf>;

  Index n1_, n2_;
  Eigen::Map<Matrix> all_;
};

using Triangle = TriangleView<float>;
using ConstTriangle = TriangleView<const float>;

/// Floats that a triangle takes.
inline std::size_t triangle_size(Eigen::Index n1, Eigen::Index n2) {
  return static_cast<std::size_t>((n1 + n2 + 1) * std::max(n1, n2));
}

/// Puts the Cholesky factor L in the matrix's place.
/// @return false where it is not positive definite; the matrix is lost then
bool factorize(Triangle matrix);

/// v <- (L L^T)^-1 v, in place. @param v [n1 + n2]
void solve(const ConstTriangle& factor, Eigen::Ref<Eigen::VectorXf> v);

}  // namespace leda::solver
