#pragma once
// How probable it is that a distance is exceeded, as a curve, and which distance is exceeded with a
// given probability.

#include <cstddef>
#include <optional>
#include <vector>

#include "solver/ensemble/interval.hpp"
#include "solver/ensemble/outcome.hpp"

namespace leda::solver {

/// How the members of a section were drawn, for the intervals. Member m belongs to replicate
/// m % replicates.
struct Replication {
  std::size_t replicates = 1;  ///< 1: independent members
  double confidence = 0.95;
};

struct CurvePoint {
  double distance_m = 0;
  double probability = 0;  ///< that the distance is exceeded
  /// Of the probability: its lower end as if every unknown distance were 0, its upper end as if it
  /// were beyond any, and the same for what censored members may exceed.
  Interval interval;
};

/// A stretch that no member ends in, with many on both sides: between its ends a quantile is not
/// known better than that.
struct Gap {
  double from_m = 0, to_m = 0;
  double probability = 0;  ///< of exceeding it
};

struct ExceedanceCurve {
  std::vector<CurvePoint> points;  ///< by distance; between them the curve is flat
  std::vector<Gap> gaps;
  double half_width = 1;                    ///< of the widest interval
  std::optional<double> censored_beyond_m;  ///< from here on members may reach further than known
};

/// Members of unknown distance count half as 0 and half as beyond any.
/// @pre reaches is not empty, its size a multiple of the replicates
ExceedanceCurve exceedance_curve(const std::vector<Reach>& reaches, const Replication& replication);

/// The distance that is exceeded with probability `exceedance` at most; nothing: any distance is
/// exceeded more often, so many members are unknown.
std::optional<double> distance_exceeded(const ExceedanceCurve& curve, double exceedance);

/// Whether members that were cut short may go beyond a distance.
bool is_lower_bound(const ExceedanceCurve& curve, double distance_m);

struct DistanceRange {
  double low_m = 0;
  std::optional<double> high_m;  ///< absent: the members know no upper end
};

struct ExceedanceQuantile {
  double exceedance = 0.5;
  std::optional<double> distance_m;  ///< absent: beyond any, so many members are unknown
  bool is_lower_bound = false;       ///< members that were cut short may reach further
  bool in_gap = false;               ///< an end of its interval lies across a gap
  DistanceRange by_ranks;            ///< exact for independent members, safe for all others
  DistanceRange by_replicates;       ///< where the curve's intervals cross the exceedance
};

/// The distance that is exceeded with probability `exceedance`, within (0, 1).
/// @param curve of the same reaches
ExceedanceQuantile exceedance_quantile(const std::vector<Reach>& reaches,
                                       const ExceedanceCurve& curve, double exceedance,
                                       const Replication& replication);

}  // namespace leda::solver
