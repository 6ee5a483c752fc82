#include "solver/ensemble/outcome.hpp"

namespace leda::solver {
namespace {

Reach reach_of(double distance_m, Bound is) {
  return is == Bound::measured ? Reach::measured(distance_m) : Reach::at_least(distance_m);
}

}  // namespace

const char* to_string(Distance distance) {
  return distance == Distance::retrogression ? "retrogression" : "runout";
}

const Reach& MemberOutcome::of(Distance distance) const {
  return distance == Distance::retrogression ? retrogression : runout;
}

std::optional<bool> MemberOutcome::slid() const {
  if (retrogression.is_unknown()) return std::nullopt;
  return retrogression.low_m > 0;
}

MemberOutcome outcome_of(const SectionResult& result) {
  MemberOutcome outcome;
  outcome.status = result.status;
  outcome.run_time_s = result.run_time_s;
  if (result.status == RunStatus::unstable || result.status == RunStatus::interrupted) {
    return outcome;
  }
  outcome.retrogression = reach_of(result.crest_to_crest_retrogression_m, result.retrogression_is);
  outcome.runout = reach_of(result.runout_m, result.runout_is);
  return outcome;
}

MemberOutcome stands() { return {RunStatus::stable, Reach::measured(0), Reach::measured(0), 0}; }

}  // namespace leda::solver
