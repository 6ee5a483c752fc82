#pragma once
// From a softening law of the case to its curve at a cell size.

#include "solver/materials/softening_curve.hpp"
#include "solver/section/material.hpp"

namespace leda::solver {

/// The curve of a law for clay of this peak strength, scaled from the size of its specimen to
/// the cell as its regularization says (smeared crack: thesis 4.5, 5.4.1).
SofteningCurve softening_curve(const Softening& softening, double peak_strength_Pa, double cell_m);

}  // namespace leda::solver
