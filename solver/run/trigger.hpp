#pragma once
// What sets a section moving: ground taken away.

#include "solver/run/run_state.hpp"
#include "solver/section/toe_cut.hpp"

namespace leda::solver {

/// Removes the particles inside a polygon given in section coordinates.
/// @return how many were removed
std::size_t excavate(RunState& run, const Polyline& polygon);

}  // namespace leda::solver
