#include "solver/ensemble/exceedance.hpp"

#include <algorithm>
#include <cmath>

namespace leda::solver {
namespace {

/// Narrower stretches, of the longest distance, are no gaps; nor are those at the curve's ends.
constexpr double least_gap = 0.2, least_share_beside_gap = 0.05;

/// Of the members of each replicate, those whose bound lies beyond a distance.
std::vector<std::size_t> hits_beyond(const std::vector<Reach>& reaches, double Reach::*bound,
                                     double distance_m, std::size_t replicates) {
  std::vector<std::size_t> hits(replicates, 0);
  for (std::size_t m = 0; m < reaches.size(); ++m) {
    if (reaches[m].*bound > distance_m) ++hits[m % replicates];
  }
  return hits;
}

/// A member's weight in the probability of exceeding a distance.
double weight_beyond(const Reach& reach, double distance_m) {
  if (reach.is_unknown()) return 0.5;
  return reach.low_m > distance_m ? 1 : 0;
}

CurvePoint point_at(double distance_m, const std::vector<Reach>& reaches,
                    const Replication& replication) {
  const std::size_t size = reaches.size() / replication.replicates;
  const auto interval = [&](double Reach::*bound) {
    const auto hits = hits_beyond(reaches, bound, distance_m, replication.replicates);
    return interval_of_replicates(hits, size, replication.confidence);
  };
  CurvePoint point;
  point.distance_m = distance_m;
  for (const Reach& reach : reaches) point.probability += weight_beyond(reach, distance_m);
  point.probability /= static_cast<double>(reaches.size());
  point.interval = {interval(&Reach::low_m).low, interval(&Reach::high_m).high};
  return point;
}

std::vector<double> distances_of(const std::vector<Reach>& reaches) {
  std::vector<double> distances{0};
  for (const Reach& reach : reaches) distances.push_back(reach.low_m);
  std::ranges::sort(distances);
  distances.erase(std::unique(distances.begin(), distances.end()), distances.end());
  return distances;
}

std::vector<Gap> gaps_of(const std::vector<CurvePoint>& points) {
  std::vector<Gap> gaps;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double width = points[i + 1].distance_m - points[i].distance_m;
    const double p = points[i].probability;
    if (width < least_gap * points.back().distance_m) continue;
    if (std::min(p, 1 - p) < least_share_beside_gap) continue;
    gaps.push_back({points[i].distance_m, points[i + 1].distance_m, p});
  }
  return gaps;
}

/// The value of a rank among sorted ones; rank 0 is no distance at all.
DistanceRange between_ranks(const std::vector<Reach>& reaches, const RankInterval& ranks) {
  std::vector<double> low, high;
  for (const Reach& reach : reaches) {
    low.push_back(reach.low_m);
    high.push_back(reach.high_m);
  }
  std::ranges::sort(low);
  std::ranges::sort(high);
  DistanceRange range;
  if (ranks.low > 0) range.low_m = low[ranks.low - 1];
  if (ranks.high <= high.size() && std::isfinite(high[ranks.high - 1])) {
    range.high_m = high[ranks.high - 1];
  }
  return range;
}

/// The first distance where an end of the intervals is no more than the exceedance.
std::optional<double> crossing(const ExceedanceCurve& curve, double Interval::*end,
                               double exceedance) {
  for (const CurvePoint& point : curve.points) {
    if (point.interval.*end <= exceedance) return point.distance_m;
  }
  return std::nullopt;
}

bool reaches_across(const Gap& gap, const DistanceRange& range) {
  return range.low_m <= gap.from_m && (!range.high_m || *range.high_m >= gap.to_m);
}

}  // namespace

ExceedanceCurve exceedance_curve(const std::vector<Reach>& reaches,
                                 const Replication& replication) {
  ExceedanceCurve curve;
  curve.half_width = 0;
  for (const double distance : distances_of(reaches)) {
    curve.points.push_back(point_at(distance, reaches, replication));
    curve.half_width = std::max(curve.half_width, curve.points.back().interval.half_width());
  }
  curve.gaps = gaps_of(curve.points);
  for (const Reach& reach : reaches) {
    if (reach.is_measured() || reach.is_unknown()) continue;
    curve.censored_beyond_m = std::min(reach.low_m, curve.censored_beyond_m.value_or(reach.low_m));
  }
  return curve;
}

std::optional<double> distance_exceeded(const ExceedanceCurve& curve, double exceedance) {
  for (const CurvePoint& point : curve.points) {
    if (point.probability <= exceedance) return point.distance_m;
  }
  return std::nullopt;
}

bool is_lower_bound(const ExceedanceCurve& curve, double distance_m) {
  return curve.censored_beyond_m && distance_m >= *curve.censored_beyond_m;
}

ExceedanceQuantile exceedance_quantile(const std::vector<Reach>& reaches,
                                       const ExceedanceCurve& curve, double exceedance,
                                       const Replication& replication) {
  ExceedanceQuantile quantile;
  quantile.exceedance = exceedance;
  quantile.distance_m = distance_exceeded(curve, exceedance);
  quantile.is_lower_bound = quantile.distance_m && is_lower_bound(curve, *quantile.distance_m);
  quantile.by_ranks =
      between_ranks(reaches, rank_interval(reaches.size(), 1 - exceedance, replication.confidence));
  quantile.by_replicates = {crossing(curve, &Interval::low, exceedance).value_or(0),
                            crossing(curve, &Interval::high, exceedance)};
  quantile.in_gap = std::ranges::any_of(curve.gaps, [&](const Gap& gap) {
    return reaches_across(gap, quantile.by_ranks) || reaches_across(gap, quantile.by_replicates);
  });
  return quantile;
}

}  // namespace leda::solver
