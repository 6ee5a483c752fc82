#pragma once
// Flow of remolded clay with a yield stress; the viscous share may thin under shear.
//
//   rate = 0                            |tau| <= tau_0
//   |tau| = tau_0 + eta |rate|^n        |tau| >  tau_0
//
// Source: Herschel and Bulkley, thesis eq. 2-7. Parameters: tau_0 >= 0, Pa (the degraded strength
// s_u); eta > 0, Pa s^n; n > 0. rate is the engineering plastic shear strain rate, 1/s.
// Limits: n = 1 is Bingham; eta -> 0 is plastic flow at tau_0.

#include <cmath>

#include "solver/section/rate.hpp"

namespace leda::solver {

/// Shear stress while it flows, Pa.
inline double flow_stress(const HerschelBulkleyFlow& law, double yield_Pa, double rate) {
  return yield_Pa + law.consistency_Pa_sn * std::pow(std::abs(rate), law.exponent);
}

/// Rate at which it flows under a shear stress, 1/s: the inverse, zero up to the yield stress.
inline double flow_rate(const HerschelBulkleyFlow& law, double yield_Pa, double stress_Pa) {
  const double over = std::abs(stress_Pa) - yield_Pa;
  return over <= 0 ? 0 : std::pow(over / law.consistency_Pa_sn, 1 / law.exponent);
}

}  // namespace leda::solver
