#pragma once
// The state of a moving run as bytes, so that it can go on in another process.

#include <string>

#include "solver/run/run_state.hpp"

namespace leda::solver {

/// Everything that a step or a result depends on and that the case does not give.
std::string save_state(const RunState& run);

/// Puts a saved state into a run that was started from the same case.
/// @return false, and an unchanged run, where the bytes are no state of this run: they hold other
///         values (names and sizes are compared), are cut short, or do not fit the case
bool load_state(const std::string& bytes, RunState& run);

}  // namespace leda::solver
