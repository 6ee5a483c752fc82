#include "solver/ensemble/sensitivity.hpp"

#include <algorithm>
#include <cmath>

namespace leda::solver {
namespace {

struct Pair {
  double input = 0, y = 0;
  std::size_t replicate = 0;
};

double mean_of(const std::vector<double>& y, std::size_t from, std::size_t to) {
  double sum = 0;
  for (std::size_t i = from; i < to; ++i) sum += y[i];
  return sum / static_cast<double>(to - from);
}

std::size_t bins_of(std::size_t members) { return members < 256 ? 8 : 16; }

/// @param y sorted by the input
std::optional<double> correlation_ratio(const std::vector<double>& y, std::size_t bins) {
  if (y.size() < 2 * bins) return std::nullopt;
  const double mean = mean_of(y, 0, y.size());
  double all = 0, between = 0;
  for (const double one : y) all += (one - mean) * (one - mean);
  if (all <= 0) return std::nullopt;
  for (std::size_t b = 0; b < bins; ++b) {
    const std::size_t from = b * y.size() / bins, to = (b + 1) * y.size() / bins;
    between += static_cast<double>(to - from) * std::pow(mean_of(y, from, to) - mean, 2);
  }
  const double within = (all - between) / static_cast<double>(y.size() - bins);
  return (between - static_cast<double>(bins - 1) * within) / all;
}

std::vector<double> without(const std::vector<Pair>& pairs, std::optional<std::size_t> replicate) {
  std::vector<double> y;
  for (const Pair& pair : pairs) {
    if (pair.replicate != replicate) y.push_back(pair.y);
  }
  return y;
}

}  // namespace

std::optional<SobolIndex> first_order_index(const std::vector<double>& input,
                                            const std::vector<std::optional<double>>& y,
                                            std::size_t replicates) {
  std::vector<Pair> pairs;
  for (std::size_t m = 0; m < y.size(); ++m) {
    if (y[m]) pairs.push_back({input[m], *y[m], m % replicates});
  }
  std::ranges::stable_sort(pairs, [](const Pair& a, const Pair& b) { return a.input < b.input; });
  const std::size_t bins = bins_of(pairs.size());
  const auto whole = correlation_ratio(without(pairs, std::nullopt), bins);
  if (!whole) return std::nullopt;
  std::vector<double> parts;
  for (std::size_t r = 0; r < replicates; ++r) {
    if (const auto part = correlation_ratio(without(pairs, r), bins)) parts.push_back(*part);
  }
  if (parts.size() < 2) return std::nullopt;
  const double mean = mean_of(parts, 0, parts.size());
  double squares = 0;
  for (const double part : parts) squares += (part - mean) * (part - mean);
  const auto count = static_cast<double>(parts.size());
  return SobolIndex{*whole, std::sqrt((count - 1) / count * squares)};
}

}  // namespace leda::solver
