#pragma once
// A bank as the empirical literature sees it: one height, one angle, one clay. SI units.

#include <optional>

namespace leda::solver {

/// The laboratory curve of the clay, thesis eq. 3-10.
struct SiteSoftening {
  double alpha = 1;
  double beta = 0;             ///< per unit strain, > 0
  double residual_strain = 0;  ///< gamma_R, fraction
};

struct Site {
  double height_m = 0;                         ///< H, crest above toe
  std::optional<double> slope_angle_deg;       ///< average, crest to toe
  double unit_weight = 0;                      ///< m, total, N/m3
  double peak_strength_Pa = 0;                 ///< s_up
  std::optional<double> remolded_strength_Pa;  ///< s_ur
  std::optional<double> peak_strain;           ///< gamma_p, fraction
  std::optional<SiteSoftening> softening;
  std::optional<double> residual_strength_Pa;  ///< s_uR; absent: 0.095 s_up (eq. 3-11)
  std::optional<double> remolded_strain;       ///< gamma_r; absent: eq. 3-13
  std::optional<double> plasticity_index;      ///< I_p, fraction
  std::optional<double> liquidity_index;       ///< I_L
  std::optional<double> preconsolidation_Pa;   ///< sigma'_p
};

}  // namespace leda::solver
