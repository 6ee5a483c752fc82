#include "solver/hindcast/mixture.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

namespace leda::solver {
namespace {

double normal_cdf(double z) { return boost::math::cdf(boost::math::normal(), z); }

constexpr double far = 10;  ///< standard deviations from the outermost component

/// Simpson's rule in steps of at most `step`: an eighth of a standard deviation gives 5 digits.
template <class Function>
double integral(const Function& f, double from, double to, double step) {
  if (!(to > from)) return 0;
  const int pairs = static_cast<int>(std::ceil((to - from) / (2 * step)));
  const double h = (to - from) / (2 * pairs);
  double sum = f(from) + f(to);
  for (int i = 1; i < 2 * pairs; ++i) sum += (i % 2 == 1 ? 4 : 2) * f(from + i * h);
  return sum * h / 3;
}

}  // namespace

void Mixture::add(double weight, double ln_distance, bool beyond) {
  if (weight > 0) parts_.push_back({weight, ln_distance, beyond});
}

void Mixture::close(double sd_ln) {
  sd_ = sd_ln;
  double sum = 0;
  for (const Part& part : parts_) sum += part.weight;
  for (Part& part : parts_) {
    part.weight /= sum;
    if (part.beyond) beyond_ += part.weight;
  }
}

double Mixture::cdf_of(double ln_distance, bool bounds_count) const {
  double sum = 0;
  for (const Part& part : parts_) {
    if (part.beyond && !bounds_count) continue;
    sum += part.weight * normal_cdf((ln_distance - part.mean) / sd_);
  }
  return sum;
}

double Mixture::cdf(double ln_distance) const { return cdf_of(ln_distance, true); }

std::optional<double> Mixture::solve(double probability, bool bounds_count) const {
  const auto [least, most] = std::ranges::minmax_element(parts_, {}, &Part::mean);
  double low = least->mean - far * sd_, high = most->mean + far * sd_;
  if (cdf_of(high, bounds_count) < probability) return std::nullopt;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (cdf_of(middle, bounds_count) < probability ? low : high) = middle;
  }
  return high;
}

double Mixture::quantile(double probability) const { return solve(probability, true).value(); }

std::optional<double> Mixture::quantile_at_most(double probability) const {
  return solve(probability, false);
}

double Mixture::crps(double ln_observed) const {
  const auto [least, most] = std::ranges::minmax_element(parts_, {}, &Part::mean);
  const double low = std::min(least->mean - far * sd_, ln_observed);
  const double high = std::max(most->mean + far * sd_, ln_observed);
  const auto below = [&](double x) { return std::pow(cdf(x), 2); };
  const auto above = [&](double x) { return std::pow(1 - cdf(x), 2); };
  const double step = sd_ / 8;
  return integral(below, low, ln_observed, step) + integral(above, ln_observed, high, step);
}

}  // namespace leda::solver
