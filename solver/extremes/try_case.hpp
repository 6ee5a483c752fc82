#pragma once
// Runs an extreme case and holds it to its promise.

#include <functional>

#include "solver/extremes/extreme_case.hpp"

namespace leda::solver {

/// @param before outcomes of the cases before it: the one it is compared with must be among them,
///        or the promise counts as broken
/// @param interrupted asked while a run goes on; true ends it, which breaks the promise
Outcome try_case(const ExtremeCase& extreme, const std::vector<Outcome>& before,
                 const std::function<bool()>& interrupted = {});

}  // namespace leda::solver
