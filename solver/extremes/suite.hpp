#pragma once
// The list of stiff and extreme cases, each with its promise.

#include "solver/extremes/extreme_case.hpp"

namespace leda::solver {

/// In an order in which a case comes after the one it is compared with.
std::vector<ExtremeCase> extreme_suite();

/// The quick ones of them: together a minute or less.
std::vector<ExtremeCase> quick_extreme_suite();

}  // namespace leda::solver
