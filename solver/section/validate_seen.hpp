#pragma once
// The part of validate() that looks for what would be left out without a word.

#include <optional>

#include "solver/section/crest_and_toe.hpp"
#include "solver/section/fault_list.hpp"

namespace leda {

/// Layers, cuts and excavations that hold no particle.
/// @pre section and settings have no other fault
void check_seen(const Section& section, const RunSettings& settings,
                const std::optional<CrestAndToe>& bank, FaultList& faults);

/// Materials that would float where the water table stands in them.
/// @pre the section and the resolution have no fault
void check_weight_under_water(const Section& section, const Resolution& resolution,
                              FaultList& faults);

}  // namespace leda
