#pragma once
// From the geostatic stress of the seeds to equilibrium, with the positions held.

#include "solver/run_state.hpp"

namespace leda::solver {

/// Elastic to equilibrium, then elastic-perfectly plastic at the undrained peak strength, both
/// at the initial damping; then plastic strain and velocity are zeroed. A section that finds no
/// equilibrium at its peak strength goes on with a warning: it slides without softening.
/// @return nothing when the stage is complete
std::optional<StageEnd> find_initial_stress(RunState& run);

}  // namespace leda::solver
