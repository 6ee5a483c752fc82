#pragma once
// What sets a section moving: ground taken away.

#include "solver/run/run_state.hpp"

namespace leda::solver {

/// Removes the particles inside a polygon given in section coordinates.
/// @return how many were removed
std::size_t excavate(RunState& run, const Polyline& polygon);

/// The polygon of a toe cut: a vertical face of this height, standing where the ground is that
/// high above the toe; all ground in front of it and above the toe goes.
Polyline toe_cut(const Section& section, const CrestAndToe& bank, double height);

}  // namespace leda::solver
