#pragma once
// The dynamic stage: softening is on, and the section stands or slides until it rests.

#include "solver/run_state.hpp"

namespace leda::solver {

/// Runs until rest or the time limit. At rest: no particle faster than 0.05 m/s for a second,
/// and kinetic energy below 1e-4 of its peak or no longer growing.
StageEnd run_softening(RunState& run, const char* stage);

}  // namespace leda::solver
