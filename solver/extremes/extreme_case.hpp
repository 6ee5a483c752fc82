#pragma once
// A stiff or extreme case, what it promises, and what came of it.

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "solver/section/run_settings.hpp"
#include "solver/section/section.hpp"
#include "solver/section/section_result.hpp"

namespace leda::solver {

using Band = std::array<double, 2>;  ///< least and most

/// What a case promises, beside what every case does: all values of frames and result are finite,
/// and mass and momentum are kept to 1e-6.
struct Promise {
  std::vector<RunStatus> statuses{RunStatus::stable, RunStatus::at_rest};
  double most_energy_error = 0.05;  ///< fraction
  std::optional<Band> retrogression_m;
  std::optional<Band> critical_number;  ///< gamma H / s_u, without unit
  /// Name of an earlier case whose critical number, or else retrogression and runout, must be met
  /// within `like_within` of it; for the distances two cells are always allowed.
  std::string like;
  double like_within = 0.1;
};

/// Instead of one run: the stability number gamma H / s_u from which the section fails, found by
/// bisection with the strength (and the stiffness with it) of every material scaled. It fails
/// where it moves, or finds no rest.
struct CriticalNumber {
  Band bracket{};
  double within = 0.03;  ///< width of the bracket at the end
};

struct ExtremeCase {
  std::string name;
  std::string extreme;  ///< what is extreme about it
  Section section;
  RunSettings settings;
  Promise promise;
  std::optional<CriticalNumber> critical;
  std::string refused_at;  ///< JSON pointer of the fault validation must find; empty: it is run
  bool unchecked = false;  ///< run although validation refuses it, to see how a run goes wrong
  bool quick = false;      ///< seconds: part of the tests that always run
};

struct Outcome {
  std::string name;
  std::string extreme;
  bool ran = false;      ///< false: refused
  std::string refusal;   ///< pointer and message of the faults
  SectionResult result;  ///< of a bisection the last run, the worst balances, all steps
  bool finite = true;    ///< every value of every frame and result
  std::optional<double> critical_number;
  double run_time_s = 0;
  std::vector<std::string> broken;  ///< promises not kept, each in a sentence

  bool kept() const { return broken.empty(); }
};

}  // namespace leda::solver
