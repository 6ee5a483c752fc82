#pragma once
// The section with a vertical face cut at its toe: what an eroding river does.

#include <optional>

#include "solver/section/crest_and_toe.hpp"
#include "solver/section/section.hpp"

namespace leda::solver {

/// Removes all ground in front of a vertical face of the given height above the toe's elevation.
/// The face stands where the bank is that height above the toe; a height above the bank's is
/// held to it. Layers given by thickness keep their place in the ground that stays.
/// @return nothing where the section has no bank
std::optional<Section> cut_toe(const Section& section, double height_m);

/// The bank of a section: as given, else found.
std::optional<CrestAndToe> bank_of(const Section& section);

}  // namespace leda::solver
