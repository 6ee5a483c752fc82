#include "solver/statics/triangle.hpp"

#include <Eigen/Cholesky>

namespace leda::solver {

namespace {

template <int Half>
bool factorize_half(Eigen::Ref<Eigen::MatrixXf> block) {
  if (block.rows() == 0) return true;
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXf>, Half> llt(block);
  return llt.info() == Eigen::Success;
}

}  // namespace

bool factorize(Triangle matrix) {
  if (!factorize_half<Eigen::Lower>(matrix.t1())) return false;
  auto below = matrix.s();
  if (below.size() > 0) {
    matrix.t1().triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(below);
    matrix.t2_transposed().selfadjointView<Eigen::Upper>().rankUpdate(below, -1.0F);
  }
  return factorize_half<Eigen::Upper>(matrix.t2_transposed());
}

void solve(const ConstTriangle& factor, Eigen::Ref<Eigen::VectorXf> v) {
  const auto t1 = factor.t1().triangularView<Eigen::Lower>();
  const auto t2 = factor.t2_transposed().triangularView<Eigen::Upper>();
  const auto s = factor.s();
  auto upper = v.head(s.cols()), lower = v.tail(s.rows());
  t1.solveInPlace(upper);
  lower.noalias() -= s * upper;
  t2.transpose().solveInPlace(lower);
  t2.solveInPlace(lower);
  upper.noalias() -= s.transpose() * lower;
  t1.transpose().solveInPlace(upper);
}

}  // namespace leda::solver
