#pragma once
// What one run says about one section.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solver/section/engine.hpp"
#include "solver/section/geometry.hpp"

namespace leda {

enum class RunStatus { stable, at_rest, time_limit, left_domain, unstable, interrupted };

const char* to_string(RunStatus status);
std::optional<RunStatus> run_status_from(const std::string& text);

/// What a distance is: the end of a slide, or as far as the run followed it.
enum class Bound { measured, lower_bound };

const char* to_string(Bound bound);  ///< "measured", "lower-bound"
std::optional<Bound> bound_from(const std::string& text);

/// Relative errors; 0 is exact. Definitions: solver/README.md, "Audits".
struct Balances {
  double mass = 0;
  double momentum = 0;
  double energy = 0;
};

/// Distances in m; definitions and thresholds: solver/README.md, "Retrogression and runout".
struct SectionResult {
  RunStatus status = RunStatus::unstable;
  std::string reason;  ///< why a run is unstable or ended early; empty otherwise
  double crest_to_crest_retrogression_m = 0;
  double runout_m = 0;             ///< from the initial toe
  double runout_from_crest_m = 0;  ///< from the initial crest
  Bound retrogression_is = Bound::measured;
  Bound runout_is = Bound::measured;
  Point crest;               ///< initial
  Point toe;                 ///< initial
  Point backscarp;           ///< after
  Point front;               ///< after
  std::string trigger_used;  ///< "none", "undrained", "toe-cut" or "excavation"
  int slides = 0;
  std::optional<double> rate_from_s;  ///< when strength began to depend on the rate; absent: never
  double simulated_s = 0;
  double run_time_s = 0;
  std::int64_t steps = 0;
  std::int64_t particles = 0;
  double ns_per_particle_step = 0;
  Balances balances;
  double numerical_dissipation = 0;  ///< share of the released energy lost in transfers
  Polyline profile_after;
  std::vector<std::string> warnings;
  std::string case_sha256;
  std::string version;           ///< of the program, with its commit
  std::optional<Engine> engine;  ///< absent: computed before results named it
};

/// Whether the model's edge cut a distance short: a warning then ends with "is a lower bound".
bool reached_edge(const SectionResult& result);

/// Marks as lower bounds the distances of a run that did not end by coming to rest, and those that
/// a warning says the model's edge cut short.
void mark_lower_bounds(SectionResult& result);

}  // namespace leda
