#include "solver/hindcast/shared_shift.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>
#include <optional>

namespace leda::solver {
namespace {

std::vector<std::size_t> by_value(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });
  return order;
}

/// Each value stands at the middle of its weight; between them in a straight line.
double weighted_quantile(const std::vector<double>& values, const std::vector<std::size_t>& order,
                         const std::vector<double>& weights, double probability) {
  double before = 0, last_middle = 0;
  std::optional<double> last;
  for (const std::size_t i : order) {
    if (!(weights[i] > 0)) continue;
    const double middle = before + 0.5 * weights[i];
    if (middle >= probability) {
      const double part = (probability - last_middle) / (middle - last_middle);
      return last ? std::lerp(*last, values[i], part) : values[i];
    }
    before += weights[i];
    last_middle = middle;
    last = values[i];
  }
  return last.value_or(values[order.back()]);
}

CentralInterval central_interval(const std::vector<double>& values,
                                 const std::vector<std::size_t>& order,
                                 const std::vector<double>& weights, double confidence) {
  const auto at = [&](double p) { return weighted_quantile(values, order, weights, p); };
  return {at((1 - confidence) / 2), at(0.5), at((1 + confidence) / 2)};
}

}  // namespace

InputShift shift_of(const std::vector<double>& values, const std::vector<double>& prior,
                    const std::vector<double>& posterior, double confidence) {
  const auto order = by_value(values);
  InputShift shift;
  shift.prior = central_interval(values, order, prior, confidence);
  shift.posterior = central_interval(values, order, posterior, confidence);
  double before = 0, mean = 0, square = 0, prior_mean = 0, prior_square = 0;
  for (const std::size_t i : order) {
    const double rank = std::clamp(before + 0.5 * prior[i], 1e-9, 1 - 1e-9);
    const double score = boost::math::quantile(boost::math::normal(), rank);
    before += prior[i];
    mean += posterior[i] * score;
    square += posterior[i] * score * score;
    prior_mean += prior[i] * score;
    prior_square += prior[i] * score * score;
  }
  const double prior_sd = std::sqrt(prior_square - prior_mean * prior_mean);
  shift.shift = (mean - prior_mean) / prior_sd;
  shift.narrowing = std::sqrt(std::max(square - mean * mean, 0.0)) / prior_sd;
  return shift;
}

}  // namespace leda::solver
