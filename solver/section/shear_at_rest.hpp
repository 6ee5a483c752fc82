#pragma once
// How near the ground is to its strength before anything happens.

#include <optional>

#include "solver/section/section.hpp"

namespace leda {

/// Least s_u / tau over the softening ground, tau = (1 - K0) sigma'_v / 2 being the greatest shear
/// stress of the state at rest under the ground above. Below 1 softening clay yields wherever it
/// lies, and a slide runs on by itself.
/// @param lower_water_m by which the water stands lower than the section says
/// @return nothing where no ground softens
std::optional<double> factor_at_rest(const Section& section, double lower_water_m = 0);

/// Of the ground, by area, where tau as above is beyond the peak strength.
double share_beyond_strength_at_rest(const Section& section);

}  // namespace leda
