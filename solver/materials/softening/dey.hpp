#pragma once
// Dey et al.: Einav-Randolph up to twice gamma_95, then linear to the large-displacement strength.
//
//   s_u = s_uR + (s_up - s_uR) exp(-3 gamma / gamma_95)                     gamma <= 2 gamma_95
//   s_u = s_uR - (s_uR - s_ld) (gamma - 2 gamma_95)/(gamma_ld - 2 gamma_95) up to gamma_ld
//   s_u = s_ld                                                              beyond
//
// Source: Dey et al. 2015, thesis eq. 2-2, written there over the plastic shear displacement delta'
// of a band of thickness t; gamma = delta'/t (thesis, below eq. 2-3), with t the reference size.
// The thesis writes s_ur and delta_r for the large-displacement strength and displacement.
// Parameters: gamma_95 > 0, gamma_ld >= 2 gamma_95 (fractions), s_ld <= s_uR <= s_up.
// The law jumps down by (s_up - s_uR) exp(-6) = 0.25 % of the loss at 2 gamma_95; kept as printed.
// The plateau delta_pc before the loss is left out: eq. 2-2 counts delta' from its end.

#include <algorithm>

#include "solver/materials/softening_curve.hpp"
#include "solver/section/material.hpp"

namespace leda::solver {

inline SofteningCurve curve_of(const DeySoftening& law, double peak_Pa) {
  const double residual = std::min(law.remolded_strength_Pa, peak_Pa);
  return {.peak = peak_Pa,
          .floor = residual,
          .amplitude = peak_Pa - residual,
          .rate = 3 / law.strain_95,
          .exp_end = 2 * law.strain_95,
          .line_start = residual,
          .line_end = std::max(law.large_strain, 2 * law.strain_95),
          .last = std::min(law.large_strain_strength_Pa, residual)};
}

}  // namespace leda::solver
