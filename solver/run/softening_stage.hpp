#pragma once
// The dynamic stage: softening is on, and the section stands or slides until it rests.

#include "solver/run/run_state.hpp"

namespace leda::solver {

/// Runs the stage until rest or the time limit; a resumed run goes on within its stage. At rest:
/// no particle faster than 0.05 m/s for a second, and kinetic energy below 1e-4 of its peak or no
/// longer growing.
StageEnd run_stage(RunState& run, StageClock::Stage stage);

/// What computes the stage under way; between stages, the quiet ones.
Engine engine_of(const RunState& run);

/// Hands a frame of the present state to the listener, if it wants one.
void show_frame(RunState& run);

}  // namespace leda::solver
