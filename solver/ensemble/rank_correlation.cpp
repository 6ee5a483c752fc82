#include "solver/ensemble/rank_correlation.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numbers>

namespace leda::solver {

std::optional<Copula> Copula::make(std::size_t inputs,
                                   const std::vector<RankCorrelation>& correlations) {
  Copula copula;
  copula.inputs_ = inputs;
  if (correlations.empty()) return copula;
  const auto size = static_cast<Eigen::Index>(inputs);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(size, size);
  for (const RankCorrelation& c : correlations) {
    const auto i = static_cast<Eigen::Index>(c.first), j = static_cast<Eigen::Index>(c.second);
    matrix(i, j) = matrix(j, i) = 2 * std::sin(std::numbers::pi * c.rho / 6);
  }
  const Eigen::LLT<Eigen::MatrixXd> factored(matrix);
  if (factored.info() != Eigen::Success) return std::nullopt;
  const Eigen::MatrixXd lower = factored.matrixL();
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) copula.factor_.push_back(lower(i, j));
  }
  return copula;
}

std::vector<double> Copula::operator()(const std::vector<double>& u) const {
  if (factor_.empty()) return u;
  const boost::math::normal normal;
  std::vector<double> z, correlated;
  for (const double one : u) z.push_back(boost::math::quantile(normal, one));
  for (std::size_t i = 0; i < inputs_; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j <= i; ++j) sum += factor_[i * inputs_ + j] * z[j];
    const double one = boost::math::cdf(normal, sum);
    correlated.push_back(std::clamp(one, 0x1p-54, 1 - 0x1p-53));
  }
  return correlated;
}

}  // namespace leda::solver
