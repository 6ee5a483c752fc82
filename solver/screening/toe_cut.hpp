#pragma once
// The ground with a vertical face cut at its toe: what an eroding river does.

#include <optional>

#include "solver/section/crest_and_toe.hpp"
#include "solver/section/section.hpp"

namespace leda::solver {

/// The bank of a section: as given, else found.
std::optional<CrestAndToe> bank_of(const Section& section);

/// The ground after all of it between a vertical face and the toe that lies above the toe's
/// elevation is removed. The face stands where the bank, seen from the toe, is first `height_m`
/// above it; a height above the bank's is held to it.
/// @return the new ground line, with the face as a vertical step
Polyline ground_after_toe_cut(const Polyline& ground, const CrestAndToe& bank, double height_m);

}  // namespace leda::solver
