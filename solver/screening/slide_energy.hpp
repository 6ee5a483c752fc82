#pragma once
// The energies per volume that are not of the softening curve, J/m3.

namespace leda::solver {

/// w_LS = 0.013 sigma'_p, the strain energy up to the peak (Tavenas et al. 1979; eq. 3-3).
inline double limit_state_energy(double preconsolidation_Pa) { return 0.013 * preconsolidation_Pa; }

/// gamma_p = 2 w_LS / s_up: elastic up to the peak (eq. 3-5).
inline double peak_strain_from(double limit_state_energy_J, double peak_strength_Pa) {
  return 2 * limit_state_energy_J / peak_strength_Pa;
}

/// E_P = 2 m H / 3 (Table 3-5).
inline double potential_energy(double unit_weight, double height_m) {
  return 2 * unit_weight * height_m / 3;
}

/// I_D = E_P / E_R (Locat et al. 2008; thesis 3.4.4).
inline double destruction_index(double potential_J, double remolding_J) {
  return potential_J / remolding_J;
}

}  // namespace leda::solver
