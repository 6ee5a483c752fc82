#include "solver/element_test/decay_fit.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

namespace leda::solver {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Unknowns ln alpha, ln beta and, if asked for, logit of floor/peak: no step leaves the law.
Decay decay_of(const VectorXd& unknowns, double peak, double floor) {
  Decay decay{std::exp(unknowns[0]), std::exp(unknowns[1]), floor};
  if (unknowns.size() == 3) decay.floor = peak / (1 + std::exp(-unknowns[2]));
  return decay;
}

/// Residuals of the stress over the peak, in the form that Eigen's optimizer asks for.
struct Residuals {
  using Scalar = double;
  using InputType = VectorXd;
  using ValueType = VectorXd;
  using JacobianType = MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  const std::vector<double>& x;
  const std::vector<double>& s;
  double peak;
  double floor;
  Eigen::Index unknowns;

  Eigen::Index inputs() const { return unknowns; }
  Eigen::Index values() const { return static_cast<Eigen::Index>(x.size()); }
  int operator()(const VectorXd& u, VectorXd& residual) const {
    const Decay decay = decay_of(u, peak, floor);
    for (std::size_t i = 0; i < x.size(); ++i) {
      residual[static_cast<Eigen::Index>(i)] = (stress(decay, peak, x[i]) - s[i]) / peak;
    }
    return 0;
  }
};

/// Standard errors of ln alpha and ln beta times alpha and beta.
void add_errors(DecayFit& fit, Eigen::NumericalDiff<Residuals, Eigen::Central>& residuals,
                const VectorXd& u) {
  const Eigen::Index spare = residuals.values() - u.size();
  if (spare <= 0) return;
  VectorXd r(residuals.values());
  MatrixXd jacobian(residuals.values(), u.size());
  residuals(u, r);
  residuals.df(u, jacobian);
  const MatrixXd covariance =
      (jacobian.transpose() * jacobian).inverse() * r.squaredNorm() / static_cast<double>(spare);
  fit.alpha_error = fit.decay.alpha * std::sqrt(std::max(0.0, covariance(0, 0)));
  fit.beta_error = fit.decay.beta * std::sqrt(std::max(0.0, covariance(1, 1)));
}

}  // namespace

double stress(const Decay& d, double peak, double x) {
  return std::min(peak, d.floor + (peak - d.floor) * d.alpha * std::exp(-d.beta * x));
}

std::optional<Decay> trend_line(const std::vector<double>& x, const std::vector<double>& s,
                                double peak, double floor) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (s[i] <= floor) continue;
    const double y = std::log((s[i] - floor) / (peak - floor));
    n += 1;
    sx += x[i];
    sy += y;
    sxx += x[i] * x[i];
    sxy += x[i] * y;
  }
  const double spread = n * sxx - sx * sx;
  if (n < 2 || !(spread > 0)) return {};
  const double slope = (n * sxy - sx * sy) / spread;
  if (!(slope < 0)) return {};
  return Decay{std::exp((sy - slope * sx) / n), -slope, floor};
}

std::optional<DecayFit> least_squares(const std::vector<double>& x, const std::vector<double>& s,
                                      double peak, const Decay& start, bool fit_floor) {
  VectorXd u(fit_floor ? 3 : 2);
  u[0] = std::log(start.alpha);
  u[1] = std::log(start.beta);
  if (fit_floor) {
    const double share = std::clamp(start.floor / peak, 1e-6, 1 - 1e-6);
    u[2] = std::log(share / (1 - share));
  }
  if (static_cast<Eigen::Index>(x.size()) < u.size()) return {};
  Eigen::NumericalDiff<Residuals, Eigen::Central> residuals(
      Residuals{x, s, peak, start.floor, u.size()});
  Eigen::LevenbergMarquardt<decltype(residuals)> solver(residuals);
  solver.parameters.ftol = solver.parameters.xtol = 1e-14;
  solver.parameters.maxfev = 2000;
  solver.minimize(u);
  DecayFit fit{decay_of(u, peak, start.floor)};
  const bool sound = u.allFinite() && std::isfinite(fit.decay.alpha) && fit.decay.beta > 0 &&
                     std::isfinite(fit.decay.beta);
  if (!sound) return {};
  add_errors(fit, residuals, u);
  return fit;
}

}  // namespace leda::solver
