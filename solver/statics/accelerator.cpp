#include "solver/statics/accelerator.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace leda::solver {

namespace {
constexpr double least_independent = 1e-13;  // share of the largest difference, energy norm
}

Accelerator::Accelerator(Eigen::Index unknowns, int remembered)
    : most_(remembered),
      moves_(unknowns, remembered),
      corrections_(unknowns, remembered),
      residuals_(unknowns, remembered),
      gram_(Eigen::MatrixXd::Zero(remembered, remembered)) {}

void Accelerator::remember(const Vector& x, const Vector& correction, const Vector& residual) {
  const Eigen::Index at = oldest_;
  corrections_.col(at) = (correction - correction_).cast<float>();
  moves_.col(at) = (x - x_ + correction - correction_).cast<float>();
  residuals_.col(at) = (residual - residual_).cast<float>();
  kept_ = std::min(kept_ + 1, most_);
  oldest_ = (oldest_ + 1) % most_;
  gram_.col(at).head(kept_) = along_residuals(corrections_.col(at).cast<double>());
  gram_.row(at).head(kept_) = gram_.col(at).head(kept_).transpose();
}

Accelerator::Vector Accelerator::along_residuals(const Vector& v) const {
  Vector dots(kept_);
  for (Eigen::Index i = 0; i < kept_; ++i) dots[i] = residuals_.col(i).cast<double>().dot(v);
  return dots;
}

Accelerator::Vector Accelerator::next(const Vector& x, const Vector& correction,
                                      const Vector& residual) {
  if (started_) remember(x, correction, residual);
  started_ = true;
  x_ = x;
  correction_ = correction;
  residual_ = residual;
  if (kept_ == 0) return x + correction;
  Eigen::MatrixXd normal = gram_.topLeftCorner(kept_, kept_);
  normal.diagonal().array() += least_independent * normal.diagonal().maxCoeff();
  const Vector share = normal.ldlt().solve(along_residuals(correction));
  Vector next = x + correction;
  for (Eigen::Index i = 0; i < kept_; ++i) next -= share[i] * moves_.col(i).cast<double>();
  return next;
}

}  // namespace leda::solver
