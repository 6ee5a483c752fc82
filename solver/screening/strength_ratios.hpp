#pragma once
// The dimensionless numbers of a bank of sensitive clay.

namespace leda::solver {

/// N_s = m H / s_up (Mitchell and Markell 1974; thesis 2.4.1).
inline double stability_number(double unit_weight, double height_m, double peak_strength_Pa) {
  return unit_weight * height_m / peak_strength_Pa;
}

/// S_t = s_up / s_ur.
inline double sensitivity(double peak_strength_Pa, double remolded_strength_Pa) {
  return peak_strength_Pa / remolded_strength_Pa;
}

/// I_B = (s_up - s_ur) / s_up (Bishop 1967; thesis eq. 2-20).
inline double brittleness_index(double peak_strength_Pa, double remolded_strength_Pa) {
  return (peak_strength_Pa - remolded_strength_Pa) / peak_strength_Pa;
}

}  // namespace leda::solver
