#pragma once
// How far the answer of a study depends on each axis, and on the seed.

#include "solver/study/study.hpp"

namespace leda::solver {

/// Sets `dependence` of the summary and of its settings, and `dependence_on_seed`.
/// @pre the settings are described, and the reference is chosen
void find_dependence(StudySummary& summary);

}  // namespace leda::solver
