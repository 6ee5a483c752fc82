#pragma once
// Exponential with a shape factor.
//
//   s_u = s_ur + (s_up - s_ur) exp(-eta gamma)
//
// Source: Jin et al., thesis eq. 2-17; Urmi, third appendix, Eq. 1 (eta 20 to 90, Table 0-1).
// Parameters: eta > 0 per unit strain. Limits: s_up at zero, s_ur is approached and never reached.
// The sources write the deviatoric plastic strain; here, as in every law, gamma is the accumulated
// plastic engineering shear strain.

#include <algorithm>

#include "solver/materials/softening_curve.hpp"
#include "solver/section/material.hpp"

namespace leda::solver {

/// The decay of a law that is exponential for ever. The end is a finite number far beyond any
/// strain, so that a vector lane that computes all branches meets neither 0/0 nor infinity.
inline SofteningCurve endless_decay(double peak_Pa, double remolded_Pa, double rate) {
  constexpr double never = 1e30;
  const double last = std::min(remolded_Pa, peak_Pa);
  return {.peak = peak_Pa,
          .floor = last,
          .amplitude = peak_Pa - last,
          .rate = rate,
          .exp_end = never,
          .line_start = last,
          .line_end = 2 * never,
          .last = last};
}

inline SofteningCurve curve_of(const ExponentialSoftening& law, double peak_Pa) {
  return endless_decay(peak_Pa, law.remolded_strength_Pa, law.shape_factor);
}

}  // namespace leda::solver
