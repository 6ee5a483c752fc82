#include "solver/hindcast/proposal.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <utility>

#include "solver/hindcast/weights.hpp"

namespace leda::solver {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Members that agree by chance in one coordinate do not end the search along it.
constexpr double least_variance = 1e-4;

VectorXd vector_of(const Scores& scores) {
  return VectorXd::Map(scores.data(), static_cast<Eigen::Index>(scores.size()));
}

double log_norm(std::size_t dimensions) {
  return -0.5 * static_cast<double>(dimensions) * std::log(2 * std::numbers::pi);
}

}  // namespace

struct Proposal::Parts {
  std::vector<VectorXd> means;
  std::vector<double> weights;
  MatrixXd factor;  ///< Cholesky's, of the covariance of a component
};

Proposal::Proposal(const std::vector<Scores>& members, const std::vector<double>& weights) {
  Parts parts;
  const auto d = static_cast<Eigen::Index>(members.front().size());
  VectorXd mean = VectorXd::Zero(d);
  for (std::size_t i = 0; i < members.size(); ++i) mean += weights[i] * vector_of(members[i]);
  MatrixXd covariance = least_variance * MatrixXd::Identity(d, d);
  for (std::size_t i = 0; i < members.size(); ++i) {
    const VectorXd off = vector_of(members[i]) - mean;
    covariance += weights[i] * off * off.transpose();
  }
  // Silverman's width of a kernel for so many members.
  const auto dimensions = static_cast<double>(d);
  const double width =
      std::pow(4 / ((dimensions + 2) * effective_members(weights)), 1 / (dimensions + 4));
  const double h = std::min(width, 1.0), a = std::sqrt(1 - h * h);
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (!(weights[i] > 0)) continue;
    parts.means.emplace_back(a * vector_of(members[i]) + (1 - a) * mean);
    parts.weights.push_back(weights[i]);
  }
  parts.factor = h * covariance.llt().matrixL().toDenseMatrix();
  parts_ = std::make_shared<const Parts>(std::move(parts));
}

Scores Proposal::draw(double which, const Scores& normals) const {
  std::size_t component = 0;
  for (double sum = parts_->weights[0]; which >= sum && component + 1 < parts_->means.size();) {
    sum += parts_->weights[++component];
  }
  const VectorXd point = parts_->means[component] + parts_->factor * vector_of(normals);
  return {point.data(), point.data() + point.size()};
}

double Proposal::log_density(const Scores& point) const {
  const VectorXd at = vector_of(point);
  const double log_volume = parts_->factor.diagonal().array().log().sum();
  std::vector<double> logs;
  for (std::size_t i = 0; i < parts_->means.size(); ++i) {
    const VectorXd z = parts_->factor.triangularView<Eigen::Lower>().solve(at - parts_->means[i]);
    logs.push_back(std::log(parts_->weights[i]) - 0.5 * z.squaredNorm());
  }
  return log_sum(logs) + log_norm(point.size()) - log_volume;
}

double log_standard_normal(const Scores& point) {
  return log_norm(point.size()) - 0.5 * vector_of(point).squaredNorm();
}

}  // namespace leda::solver
