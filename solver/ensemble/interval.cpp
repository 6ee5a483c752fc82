#include "solver/ensemble/interval.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numeric>

namespace leda::solver {
namespace {

using Binomial = boost::math::binomial_distribution<>;

/// That a quantile lies between two ranks.
class RankChance {
 public:
  RankChance(std::size_t members, double level) {
    const Binomial below(static_cast<double>(members), level);
    for (std::size_t k = 0; k <= members; ++k) {
      at_most_.push_back(boost::math::cdf(below, static_cast<double>(k)));
    }
  }

  double operator()(const RankInterval& ranks) const {
    const double to = ranks.high >= at_most_.size() ? 1 : at_most_[ranks.high - 1];
    return to - (ranks.low == 0 ? 0 : at_most_[ranks.low - 1]);
  }

 private:
  std::vector<double> at_most_;  ///< that at most so many members lie below the quantile
};

/// Of those between two ranks; the likelier of two that are equally narrow.
std::optional<RankInterval> narrowest(const RankChance& chance, std::size_t first, std::size_t last,
                                      double confidence) {
  std::optional<RankInterval> best;
  RankInterval ranks{first, first + 1};
  for (; ranks.low < last; ++ranks.low) {
    ranks.high = std::max(ranks.high, ranks.low + 1);
    while (ranks.high < last && chance(ranks) < confidence) ++ranks.high;
    if (chance(ranks) < confidence) break;
    const std::size_t width = ranks.high - ranks.low;
    const std::size_t narrowest = best ? best->high - best->low : width + 1;
    if (width < narrowest || (width == narrowest && chance(ranks) > chance(*best))) best = ranks;
  }
  return best;
}

}  // namespace

Interval exact_interval(std::size_t hits, std::size_t of, double confidence) {
  const double tail = (1 - confidence) / 2;
  const auto n = static_cast<double>(of), k = static_cast<double>(hits);
  Interval interval;
  if (hits > 0) interval.low = Binomial::find_lower_bound_on_p(n, k, tail);
  if (hits < of) interval.high = Binomial::find_upper_bound_on_p(n, k, tail);
  return interval;
}

Interval interval_of_replicates(const std::vector<std::size_t>& hits, std::size_t size,
                                double confidence) {
  const std::size_t replicates = hits.size(), members = replicates * size;
  const std::size_t all_hits = std::accumulate(hits.begin(), hits.end(), std::size_t{0});
  if (replicates < 2 || std::min(all_hits, members - all_hits) < replicates) {
    return exact_interval(all_hits, members, confidence);
  }
  const auto n = static_cast<double>(size), r = static_cast<double>(replicates);
  const double mean = static_cast<double>(all_hits) / (n * r);
  double squares = 0;
  for (const std::size_t one : hits) squares += std::pow(static_cast<double>(one) / n - mean, 2);
  const double variance = std::max(squares / (r - 1), 1 / (12 * n * n));
  const boost::math::students_t student(r - 1);
  const double half =
      boost::math::quantile(student, 0.5 + confidence / 2) * std::sqrt(variance / r);
  return {std::max(mean - half, 0.0), std::min(mean + half, 1.0)};
}

RankInterval rank_interval(std::size_t members, double level, double confidence) {
  const RankChance chance(members, level);
  // With an end of its own on either side where there can be one, else open.
  const auto closed = narrowest(chance, 1, members, confidence);
  return closed
             ? *closed
             : narrowest(chance, 0, members + 1, confidence).value_or(RankInterval{0, members + 1});
}

}  // namespace leda::solver
