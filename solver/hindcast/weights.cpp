#include "solver/hindcast/weights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace leda::solver {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Index of the quartile of so many, from 4 on, as its source rounds it.
std::size_t first_quartile(std::size_t count) { return (count + 2) / 4 - 1; }

/// k of a Pareto distribution with theta = k / scale, at its likeliest (Zhang and Stephens 2009).
double shape_at(double theta, const std::vector<double>& excess) {
  double sum = 0;
  for (const double x : excess) sum += std::log1p(-theta * x);
  return sum / static_cast<double>(excess.size());
}

/// @param excess over the cut, rising, not all the same
double fitted_shape(const std::vector<double>& excess) {
  const auto n = static_cast<double>(excess.size());
  const auto candidates = 30 + static_cast<std::size_t>(std::sqrt(n));
  const double quartile = excess[first_quartile(excess.size())];
  std::vector<double> thetas, profile;
  for (std::size_t j = 1; j <= candidates; ++j) {
    const double theta =
        1 / excess.back() +
        (1 - std::sqrt(static_cast<double>(candidates) / (static_cast<double>(j) - 0.5))) /
            (3 * quartile);
    const double k = shape_at(theta, excess);
    thetas.push_back(theta);
    profile.push_back(n * (std::log(-theta / k) - k - 1));
  }
  const auto weights = normalized(profile);
  const double theta = std::inner_product(thetas.begin(), thetas.end(), weights.begin(), 0.0);
  // As if 10 more had said 0.5: what few say of k is not believed at once.
  return (shape_at(theta, excess) * n + 5) / (n + 10);
}

}  // namespace

double log_sum(const std::vector<double>& logs) {
  const double most = logs.empty() ? -infinity : *std::ranges::max_element(logs);
  if (most == -infinity) return most;
  double sum = 0;
  for (const double one : logs) sum += std::exp(one - most);
  return most + std::log(sum);
}

std::vector<double> normalized(const std::vector<double>& logs) {
  const double all = log_sum(logs);
  std::vector<double> weights;
  weights.reserve(logs.size());
  for (const double one : logs) weights.push_back(all == -infinity ? 0 : std::exp(one - all));
  return weights;
}

double effective_members(const std::vector<double>& weights) {
  const double squares = std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);
  return squares > 0 ? 1 / squares : 0;
}

std::optional<double> pareto_k(const std::vector<double>& logs) {
  const auto members = static_cast<double>(logs.size());
  const auto tail =
      static_cast<std::size_t>(std::ceil(std::min(0.2 * members, 3 * std::sqrt(members))));
  if (tail < 5 || logs.size() <= tail) return std::nullopt;
  std::vector<double> sorted = logs;
  std::ranges::sort(sorted);
  const double most = sorted.back();
  const double cut = std::exp(sorted[sorted.size() - tail - 1] - most);
  std::vector<double> excess;
  for (std::size_t i = sorted.size() - tail; i < sorted.size(); ++i) {
    excess.push_back(std::exp(sorted[i] - most) - cut);
  }
  const double quartile = excess[first_quartile(tail)];
  if (!(quartile > 0) || excess.back() <= excess.front()) {
    // Members of the same weight, or so many without any that the tail has none.
    if (excess.back() <= excess.front()) return std::nullopt;
    return infinity;
  }
  return fitted_shape(excess);
}

double largest_good_k(std::size_t members) {
  return std::min(1 - 1 / std::log10(static_cast<double>(members)), 0.7);
}

std::vector<double> tempered(const std::vector<double>& log_prior,
                             const std::vector<double>& log_likelihood, double exponent) {
  std::vector<double> logs = log_prior;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const bool ruled_out = log_likelihood[i] == -infinity;
    logs[i] = ruled_out ? -infinity : logs[i] + exponent * log_likelihood[i];
  }
  return logs;
}

double tempering_exponent(const std::vector<double>& log_prior,
                          const std::vector<double>& log_likelihood, double effective) {
  const auto enough = [&](double t) {
    return effective_members(normalized(tempered(log_prior, log_likelihood, t))) >= effective;
  };
  if (enough(1)) return 1;
  double low = 0, high = 1;
  for (int i = 0; i < 50; ++i) {
    const double middle = std::midpoint(low, high);
    (enough(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace leda::solver
