#pragma once
// Einav and Randolph: exponential, 95 % of the loss at gamma_95.
//
//   s_u = s_ur + (s_up - s_ur) exp(-3 gamma / gamma_95)
//
// Source: Einav and Randolph 2005, thesis eqs 2-3, 3-4, 4-1 (and Eq. 5 of the fourth appendix).
// Parameters: gamma_95 > 0, fraction (exp(-3) = 0.0498: the name is exact to 0.02 % of the loss).
// Limits: s_up at zero, s_ur is approached and never reached.
// Thesis eq. 2-12 prints the exponent without the factor 3 beside the same definition of gamma_95;
// that is read as a slip of the pen.

#include "solver/materials/softening/exponential.hpp"

namespace leda::solver {

inline SofteningCurve curve_of(const EinavRandolphSoftening& law, double peak_Pa) {
  return endless_decay(peak_Pa, law.remolded_strength_Pa, 3 / law.strain_95);
}

}  // namespace leda::solver
