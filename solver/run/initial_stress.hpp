#pragma once
// From the geostatic stress of the seeds to equilibrium, with the positions held.

#include "solver/run/run_state.hpp"

namespace leda::solver {

/// How the balance is found.
enum class QuietMethod {
  direct,  ///< static solves (statics/); where one finds no balance, by relaxation from there on
  relaxed  ///< explicit steps at the initial damping: the reference
};

/// Puts the seeded particles into a model in double precision whose forces are kept.
void begin_quiet(RunState& run);

/// Elastic to equilibrium, then elastic-perfectly plastic at the undrained peak strength; then
/// plastic strain and velocity are zeroed. A section that finds no equilibrium at its peak
/// strength goes on with a warning: it slides without softening. Only steps of the relaxation
/// count as steps of the run.
/// @return nothing when the stage is complete
std::optional<StageEnd> find_initial_stress(RunState& run,
                                            QuietMethod method = QuietMethod::direct);

/// Puts the settled ground into the model that moves, in the precision asked for.
void begin_moving(RunState& run);

}  // namespace leda::solver
