#pragma once
// From a remolding index over strain energy to stress over strain (thesis 3.3).
//
//   s_u     = s_up - I_r (s_up - s_ur)                                  eqs 3-1, 3-7
//   W       = w_N w_LS,   w_LS = 0.013 sigma'_p                         eqs 3-2, 3-3
//   gamma_p = 2 w_LS / s_up                                             eq. 3-5
//   gamma_x = 2 (W_x - W_x-1)/(s_ux-1 + s_ux) + gamma_x-1               eq. 3-6
//
// The first step starts at the peak: s_up, gamma_p, w_LS. So W counts from zero strain, the elastic
// part included, and w_N = 1 at the peak. Eq. 3-2 prints "x 100 %"; the text (3-8, "= 190") and the
// figures use the ratio, as here. Quinn et al.'s own conversion (eq. 3-8) adds the whole energy at
// every step and is not offered: it gives strains some ten times as large.

#include "solver/element_test/lab_curve.hpp"

namespace leda::solver {

/// @param curve w_N never falling, >= 1; I_r from 0 to below 1 (s_u stays above zero)
/// @return strain and stress, the peak first
LabCurve to_stress_strain(const EnergyCurve& curve, double peak_Pa, double remolded_Pa,
                          double preconsolidation_Pa);

/// w_LS of eq. 3-3, J/m3.
double limit_state_energy(double preconsolidation_Pa);

}  // namespace leda::solver
