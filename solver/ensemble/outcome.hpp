#pragma once
// What the run of one member says of its distances: a value, at least a value, or nothing. None is
// dropped: what is not known widens the answer.

#include <limits>
#include <optional>
#include <string>

#include "solver/section/section_result.hpp"

namespace leda::solver {

/// A distance lies between low and high, m.
struct Reach {
  double low_m = 0;
  double high_m = std::numeric_limits<double>::infinity();

  static Reach measured(double distance_m) { return {distance_m, distance_m}; }
  /// Cut short by the model's edge or the time limit.
  static Reach at_least(double distance_m) { return {distance_m}; }
  /// The run ended unstable or gave no result.
  static Reach unknown() { return {}; }

  bool is_measured() const { return low_m == high_m; }
  bool is_unknown() const { return low_m == 0 && !is_measured(); }
};

enum class Distance { retrogression, runout };

const char* to_string(Distance distance);  ///< "retrogression", "runout"

struct MemberOutcome {
  std::optional<RunStatus> status;  ///< absent: no result
  Reach retrogression = Reach::unknown();
  Reach runout = Reach::unknown();
  double run_time_s = 0;

  const Reach& of(Distance distance) const;
  /// Whether the section slid; absent where that is not known.
  std::optional<bool> slid() const;
};

MemberOutcome outcome_of(const SectionResult& result);

/// Of a member that screening finds stable: it is not run, and its distances are 0.
MemberOutcome stands();

}  // namespace leda::solver
