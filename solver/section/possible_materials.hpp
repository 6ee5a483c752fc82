#pragma once
// The part of validate_materials() that looks for magnitudes no ground has: mistakes of units.

#include <string>

#include "solver/section/fault_list.hpp"

namespace leda {

/// K0 against the passive ratio, the friction angle, strength and stiffness, remolded strength,
/// rates and viscosities.
void check_possible(const Material& m, const std::string& at, FaultList& faults);

}  // namespace leda
