#pragma once
// Energy that a softening curve dissipates, per volume (Pa = J/m3). Times the height of the cell
// (or the specimen) it is energy per area of shear band: the area under stress over displacement.

#include "solver/materials/softening_curve.hpp"

namespace leda::solver {

/// Whether the law reaches its last strength: an endless exponential does not.
inline bool has_end(const SofteningCurve& curve) { return curve.line_end < 1e20; }

/// Area under the curve from zero to a plastic strain, in closed form.
/// @param strain >= 0, fraction
double dissipation(const SofteningCurve& curve, double strain);

/// The same by quadrature of strength(): independent of the closed form, for checking and for
/// laws that have none.
double dissipation_by_quadrature(const SofteningCurve& curve, double strain);

/// Area of the exponential loss above its floor, (s_up - s_uR) alpha / beta where alpha <= 1, with
/// the exponential carried on for ever (thesis 4.5 adjusts this area, by beta). For a curve without
/// exponential: the area above its last strength. Closed form.
double excess(const SofteningCurve& curve);

/// The same by quadrature.
double excess_by_quadrature(const SofteningCurve& curve);

/// The exponential's area above its floor counted to gamma_R only, by quadrature.
double excess_to_residual_strain(const SofteningCurve& curve);

/// Steepest loss of strength over plastic strain, Pa. Where it exceeds G a sheared element snaps
/// back: its stress drops at once under a given strain.
double steepest_loss(const SofteningCurve& curve);

}  // namespace leda::solver
