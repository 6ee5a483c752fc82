#pragma once
// What the members of one section say together. All of it is conditional on a slide starting at
// that section: it is no yearly probability and no class of a regulation.

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "solver/ensemble/chance.hpp"
#include "solver/ensemble/draws.hpp"
#include "solver/ensemble/exceedance.hpp"
#include "solver/ensemble/outcome.hpp"
#include "solver/ensemble/sensitivity.hpp"
#include "solver/ensemble/stopping.hpp"

namespace leda::solver {

inline constexpr std::array distances{Distance::retrogression, Distance::runout};

/// Paired runs that tell chance and the cell apart from the inputs.
struct CheckRule {
  std::optional<double> cell_m;  ///< of a finer run of each; absent: none
  std::size_t members = 16;      ///< the first ones
  std::size_t seeds = 1;         ///< runs of each with its inputs, the member itself among them
};

/// What to do with a section, beside its inputs.
struct EnsemblePlan {
  std::vector<UncertainInput> inputs;
  std::vector<RankCorrelation> correlations;
  Sampling sampling;
  StopRule stop;
  std::optional<CheckRule> check;
  std::vector<double> exceedance{0.05, 0.2, 0.5, 0.8, 0.95};

  Replication replication() const;
};

struct Member {
  std::vector<double> inputs;  ///< as drawn, in the order of the plan
  MemberOutcome outcome;
  std::vector<MemberOutcome> repeats;  ///< with other seeds
  std::optional<MemberOutcome> finer;
};

/// Of an indicator: the distance is exceeded.
struct IndexBeyond {
  double distance_m = 0;
  std::vector<std::optional<SobolIndex>> indices;
};

struct DistanceSummary {
  ExceedanceCurve curve;
  std::vector<ExceedanceQuantile> quantiles;       ///< in the order of the plan
  std::vector<std::optional<SobolIndex>> indices;  ///< one an input
  std::vector<IndexBeyond> beyond;                 ///< at the quantiles that are above 0
  std::optional<ChanceShare> chance;
  std::optional<CellShift> cell;
};

struct EnsembleSummary {
  std::size_t members = 0;
  std::map<std::string, std::size_t> by_status;  ///< "at-rest", ..., "no-result"
  double probability_of_sliding = 0;
  Interval sliding;  ///< of that probability
  std::map<Distance, DistanceSummary> by_distance;
  double half_width = 1;  ///< of the wider curve
  Ending ending = Ending::more_members;
  double core_s = 0;  ///< run times of members, repeats and finer runs
};

/// @pre members is not empty, their number a multiple of the replicates
EnsembleSummary summarize(const EnsemblePlan& plan, const std::vector<Member>& members);

}  // namespace leda::solver
