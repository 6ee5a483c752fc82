#pragma once
// Urmi et al.: an exponential loss down to the residual strength, then a linear one down to the
// remolded strength.
//
//   s_u = s_uR + (s_up - s_uR) alpha exp(-beta gamma)                  gamma <= gamma_R
//   s_u = s_uR - (s_uR - s_ur) (gamma - gamma_R)/(gamma_r - gamma_R)   gamma_R < gamma < gamma_r
//   s_u = s_ur                                                         gamma >= gamma_r
//   s_uR = 0.095 s_up,   gamma_r = 0.13 s_up[kPa] gamma_R              where not given
//
// Source: Urmi, thesis eqs 3-10 to 3-13 (chapter 3) = 4-2 to 4-4 (chapter 4) = 5-2 to 5-4.
// Parameters: alpha 0.64 to 1.53 (Tables 3-2, 3-4), beta > 0 per unit strain, gamma_R a fraction.
//
// Readings the thesis leaves open, as taken here:
// - gamma is the accumulated plastic engineering shear strain, so the law starts at yield.
// - The exponential branch ends at s_uR (chapters 3 to 5), not at s_ur (fourth appendix, Eq. 6).
// - The strength never exceeds s_up (alpha > 1 would give more at small strain). With alpha < 1 the
//   law gives less than s_up at zero strain: whoever steps a particle holds s_up until it yields.
// - The law jumps down at gamma_R by (s_up - s_uR) alpha exp(-beta gamma_R), 0.07 to 0.23 kPa for
//   the sites of Table 3-4, because gamma_R was read off a plot; it is kept as printed.
// - Where eq. 4-4 puts gamma_r before gamma_R (s_up < 7.7 kPa) the line is skipped: the strength
//   goes to s_ur at gamma_R. Where eq. 4-3 puts s_uR under s_ur (S_t < 10.5), s_uR = s_ur.

#include <algorithm>
#include <cmath>

#include "solver/materials/softening_curve.hpp"
#include "solver/section/material.hpp"

namespace leda::solver {

/// s_uR of a law, Pa: the one given, or eq. 4-3.
inline double residual_strength(const UrmiSoftening& law, double peak_Pa) {
  const double last = std::min(law.remolded_strength_Pa, peak_Pa);
  return std::clamp(law.residual_strength_Pa.value_or(0.095 * peak_Pa), last, peak_Pa);
}

/// gamma_r of a law, fraction: the one given, or eq. 4-4.
inline double remolded_strain(const UrmiSoftening& law, double peak_Pa) {
  const double peak_kPa = peak_Pa / 1000;
  return std::max(law.residual_strain,
                  law.remolded_strain.value_or(0.13 * peak_kPa * law.residual_strain));
}

inline SofteningCurve curve_of(const UrmiSoftening& law, double peak_Pa) {
  const double residual = residual_strength(law, peak_Pa);
  return {.peak = peak_Pa,
          .floor = residual,
          .amplitude = (peak_Pa - residual) * law.alpha,
          .rate = law.beta,
          .exp_end = law.residual_strain,
          .line_start = residual,
          .line_end = remolded_strain(law, peak_Pa),
          .last = std::min(law.remolded_strength_Pa, peak_Pa)};
}

}  // namespace leda::solver
