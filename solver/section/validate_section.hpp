#pragma once
// The parts of validate() that look at the shape of a section.

#include <optional>

#include "solver/section/crest_and_toe.hpp"
#include "solver/section/fault_list.hpp"

namespace leda {

/// Ground and base. @return whether the other checks may rely on them
bool check_ground(const Section& section, FaultList& faults);

/// Where a list of layers stands in a case file: "/layers", "/columns/1/layers".
std::string layers_pointer(const Section& section, std::size_t list);

/// Each layer of a list alone, their order, and their materials.
void check_layers(const std::vector<Layer>& layers,
                  const std::map<std::string, Material>& materials, const std::string& at,
                  FaultList& faults);

/// Every list of layers; columns cover the ground from end to end without a gap.
/// @param ground_is_sound whether check_ground() found nothing
void check_soil(const Section& section, bool ground_is_sound, FaultList& faults);

/// @pre check_ground
void check_water_table(const Section& section, FaultList& faults);

/// A crest or toe given by hand lies on the ground; a section without them has a bank.
/// @return the bank in use, where there is one
/// @pre check_ground
std::optional<CrestAndToe> check_bank(const Section& section, FaultList& faults);

}  // namespace leda
