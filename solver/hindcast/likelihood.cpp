#include "solver/hindcast/likelihood.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace leda::solver {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double normal_cdf(double z) { return boost::math::cdf(boost::math::normal(), z); }

/// Where the other end is the nearer tail, so that no digits are lost in 1 - p.
double between(double low, double high) {
  return low > 0 ? normal_cdf(-low) - normal_cdf(-high) : normal_cdf(high) - normal_cdf(low);
}

double log_density(double z, double sd) {
  return -0.5 * z * z - std::log(sd * std::sqrt(2 * std::numbers::pi));
}

/// One distance: what was observed as a range of ln y - ln f - b, a point where it was measured.
struct Residual {
  double low = 0, high = 0, sd = 1;
  bool measured() const { return low == high; }
  double log_probability(double mean, double own_sd) const {
    if (measured()) return log_density((low - mean) / own_sd, own_sd);
    return std::log(between((low - mean) / own_sd, (high - mean) / own_sd));
  }
};

Residual residual_of(const Observed& observed, const Reach& reach, double least_m,
                     const Discrepancy& discrepancy, double bias_ln) {
  const double model = ln_counted(observed, reach, least_m, bias_ln) + bias_ln;
  Residual r;
  r.sd = std::hypot(discrepancy.sd_ln, observed.value_m ? observed.sd_ln : 0);
  if (observed.value_m) {
    r.low = r.high = std::log(*observed.value_m) - model;
    return r;
  }
  // A model beyond any bound leaves no doubt about a lower one.
  r.low = observed.at_least_m && std::isfinite(model) ? std::log(*observed.at_least_m) - model
                                                      : -infinity;
  r.high = observed.at_most_m ? std::log(*observed.at_most_m) - model : infinity;
  return r;
}

/// Both distances: the first one alone, times the second one given the first.
double log_joint(const Residual& first, const Residual& second, double covariance) {
  const double r = covariance / (first.sd * second.sd);
  const double rest_sd = second.sd * std::sqrt(1 - r * r);
  const auto second_given = [&](double z) {
    return second.log_probability(r * second.sd * z, rest_sd);
  };
  if (first.measured()) {
    return first.log_probability(0, first.sd) + second_given(first.low / first.sd);
  }
  if (second.measured()) return log_joint(second, first, covariance);
  constexpr double far = 10;  // standard deviations
  const double low = std::max(first.low / first.sd, -far),
               high = std::min(first.high / first.sd, far);
  if (low >= high) return first.log_probability(0, first.sd) + second.log_probability(0, second.sd);
  const auto density = [&](double z) { return std::exp(log_density(z, 1) + second_given(z)); };
  return std::log(
      boost::math::quadrature::gauss_kronrod<double, 31>::integrate(density, low, high, 10, 1e-9));
}

}  // namespace

double ln_counted(const Observed& observed, const Reach& reach, double least_m, double bias_ln) {
  const double low = std::max(reach.low_m, least_m), high = std::max(reach.high_m, least_m);
  double nearest = observed.at_least_m ? infinity : 0;
  if (observed.at_least_m && observed.at_most_m) {
    nearest = std::sqrt(*observed.at_least_m * *observed.at_most_m) * std::exp(-bias_ln);
  }
  if (observed.value_m) nearest = *observed.value_m * std::exp(-bias_ln);
  return std::log(std::clamp(nearest, low, high));
}

double log_likelihood(const PastSlide& slide, const Reach& retrogression, const Reach& runout,
                      const Discrepancy& discrepancy, double bias_ln) {
  const auto residual = [&](const Observed& observed, const Reach& reach) {
    return residual_of(observed, reach, slide.least_m, discrepancy, bias_ln);
  };
  if (slide.retrogression && slide.runout) {
    const double covariance = discrepancy.correlation * discrepancy.sd_ln * discrepancy.sd_ln;
    return log_joint(residual(*slide.retrogression, retrogression), residual(*slide.runout, runout),
                     covariance);
  }
  const Residual only = slide.retrogression ? residual(*slide.retrogression, retrogression)
                                            : residual(*slide.runout, runout);
  return only.log_probability(0, only.sd);
}

}  // namespace leda::solver
