#include "solver/ensemble/distribution.hpp"

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <cmath>
#include <numeric>

namespace leda::solver {
namespace {

namespace math = boost::math;

/// Weights are written with a few digits: that much may be missing from 1.
constexpr double weights_tolerance = 1e-6;

double quantile_of(const Normal& d, double u) {
  const math::normal normal(d.mean, d.sd);
  const double below = d.min ? math::cdf(normal, *d.min) : 0;
  const double above = d.max ? math::cdf(math::complement(normal, *d.max)) : 0;
  const double p = below + u * (1 - below - above);
  const double q = (1 - u) * (1 - below - above) + above;
  // From the nearer tail, where digits are not lost in 1 - p.
  double value = p < 0.5 ? math::quantile(normal, p) : math::quantile(math::complement(normal, q));
  if (d.min) value = std::max(value, *d.min);
  if (d.max) value = std::min(value, *d.max);
  return value;
}

double quantile_of(const Lognormal& d, double u) {
  return d.median * std::exp(d.sd_ln * math::quantile(math::normal(), u));
}

double quantile_of(const Uniform& d, double u) { return d.min + u * (d.max - d.min); }

double quantile_of(const Triangular& d, double u) {
  return math::quantile(math::triangular(d.min, d.mode, d.max), u);
}

double quantile_of(const Pert& d, double u) {
  const double range = d.max - d.min;
  const math::beta_distribution<> beta(1 + 4 * (d.mode - d.min) / range,
                                       1 + 4 * (d.max - d.mode) / range);
  return d.min + range * math::quantile(beta, u);
}

double in_steps(const std::vector<double>& values, const std::vector<double>& weights, double u) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    sum += weights[i];
    if (u < sum) return values[i];
  }
  return values.back();
}

double quantile_of(const Discrete& d, double u) { return in_steps(d.values, d.weights, u); }
double quantile_of(const JointSample& d, double u) { return in_steps(d.values, d.weights, u); }

void check_of(const Normal& d, const std::string& at, FaultList& faults) {
  faults.within(at + "/sd", d.sd, d.sd > 0, "greater than 0");
  if (d.min && d.max) {
    faults.within(at + "/max", *d.max, *d.max > *d.min, "greater than min, " + show(*d.min));
  }
  if (d.sd <= 0 || (d.min && d.max && *d.max <= *d.min)) return;
  const math::normal normal(d.mean, d.sd);
  const double below = d.min ? math::cdf(normal, *d.min) : 0;
  const double above = d.max ? math::cdf(math::complement(normal, *d.max)) : 0;
  if (below + above > 0.99) {
    faults.add(at,
               "less than 1 % of the normal distribution lies between min and max: the bounds "
               "and the mean do not belong together");
  }
}

void check_of(const Lognormal& d, const std::string& at, FaultList& faults) {
  faults.within(at + "/median", d.median, d.median > 0, "greater than 0");
  faults.within(at + "/sd_ln", d.sd_ln, d.sd_ln > 0 && d.sd_ln <= 3, "above 0 and at most 3");
}

void check_of(const Uniform& d, const std::string& at, FaultList& faults) {
  faults.within(at + "/max", d.max, d.max > d.min, "greater than min, " + show(d.min));
}

template <class Peaked>
void check_peaked(const Peaked& d, const std::string& at, FaultList& faults) {
  if (!faults.within(at + "/max", d.max, d.max > d.min, "greater than min, " + show(d.min))) return;
  faults.within(at + "/mode", d.mode, d.mode >= d.min && d.mode <= d.max,
                "between min and max, " + show(d.min) + " and " + show(d.max));
}

void check_of(const Triangular& d, const std::string& at, FaultList& faults) {
  check_peaked(d, at, faults);
}
void check_of(const Pert& d, const std::string& at, FaultList& faults) {
  check_peaked(d, at, faults);
}

template <class Steps>
void check_steps(const Steps& d, const std::string& at, FaultList& faults) {
  if (d.values.empty()) faults.add(at + "/values", "is an empty list");
  if (d.values.size() != d.weights.size()) {
    faults.add(at + "/weights", "has " + std::to_string(d.weights.size()) +
                                    " weights, must have one for each of the " +
                                    std::to_string(d.values.size()) + " values");
    return;
  }
  for (std::size_t i = 0; i < d.weights.size(); ++i) {
    faults.within(at + "/weights/" + std::to_string(i), d.weights[i], d.weights[i] >= 0,
                  "at least 0");
  }
  const double sum = std::accumulate(d.weights.begin(), d.weights.end(), 0.0);
  if (!d.weights.empty() && !(std::abs(sum - 1) <= weights_tolerance)) {
    faults.add(at + "/weights", "add up to " + show(sum) + ", must add up to 1");
  }
}

void check_of(const Discrete& d, const std::string& at, FaultList& faults) {
  check_steps(d, at, faults);
}
void check_of(const JointSample& d, const std::string& at, FaultList& faults) {
  check_steps(d, at, faults);
}

}  // namespace

Lognormal lognormal_of_mean(double mean, double cov) {
  return {mean / std::sqrt(1 + cov * cov), std::sqrt(std::log1p(cov * cov))};
}

bool is_continuous(const Distribution& distribution) {
  return !std::holds_alternative<Discrete>(distribution) &&
         !std::holds_alternative<JointSample>(distribution);
}

double quantile(const Distribution& distribution, double u) {
  return std::visit([&](const auto& d) { return quantile_of(d, u); }, distribution);
}

void check(const Distribution& distribution, const std::string& at, FaultList& faults) {
  std::visit([&](const auto& d) { check_of(d, at, faults); }, distribution);
}

}  // namespace leda::solver
