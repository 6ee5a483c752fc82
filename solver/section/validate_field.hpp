#pragma once
// What is impossible, and what is odd, about a strength that varies within the ground.

#include <string>
#include <vector>

#include "solver/section/fault_list.hpp"
#include "solver/section/run_settings.hpp"
#include "solver/section/section.hpp"

namespace leda {

/// @param at pointer of the material, which has a field
void check_field(const Material& m, const std::string& at, FaultList& faults);

/// Scales of fluctuation that the cells cannot follow, or that are longer than the section.
void warn_of_fields(const Section& section, const Resolution& resolution,
                    std::vector<std::string>& warnings);

}  // namespace leda
