#pragma once
// Whole runs in one precision or the other, named as the tests of the step are.

#include "solver/section/run_settings.hpp"
#include "tests/solver/precisions.hpp"

namespace leda::solver::test {

/// In single a run is as it ships; in double all ground is stepped, too.
template <class Real>
RunSettings settings_in() {
  RunSettings settings;
  if (sizeof(Real) == sizeof(double)) {
    settings.precision = Precision::double_precision;
    settings.ground_rests = false;
  }
  return settings;
}

}  // namespace leda::solver::test
