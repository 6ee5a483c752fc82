#pragma once
// Whether every number that leaves a run is one.

#include "solver/section/frame.hpp"
#include "solver/section/section_result.hpp"

namespace leda::solver {

bool is_finite(const Frame& frame);
bool is_finite(const SectionResult& result);

}  // namespace leda::solver
