#pragma once
// Published conditions for a large retrogressive slide (thesis 2.4.1), each with its verdict.

#include <vector>

#include "solver/screening/analytics.hpp"
#include "solver/screening/site.hpp"

namespace leda::solver {

/// @param known what was computed for the site so far: stability number, sensitivity, energies
std::vector<Criterion> retrogression_criteria(const Site& site, const Analytics& known);

}  // namespace leda::solver
