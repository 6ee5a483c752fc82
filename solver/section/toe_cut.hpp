#pragma once
// The ground that a toe cut takes away: what an eroding river does.

#include "solver/section/crest_and_toe.hpp"
#include "solver/section/section.hpp"

namespace leda {

/// The bank of a section: as given, else found.
std::optional<CrestAndToe> bank_in_use(const Section& section);

/// The polygon of a toe cut: a vertical face of this height, standing where the ground is that
/// high above the toe; all ground in front of it and above the toe goes.
Polyline toe_cut(const Section& section, const CrestAndToe& bank, double height_m);

}  // namespace leda
