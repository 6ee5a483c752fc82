#pragma once
// Flow of remolded clay with a yield stress and a constant viscosity.
//
//   rate = rate_e + rate_vp,   sigma = tau + eta rate_vp        beyond the yield surface
//
// Source: Bingham; Zhang et al., thesis eqs 2-18, 2-19. tau is the stress on the Tresca surface,
// so here the degraded strength s_u, Pa. Parameters: eta > 0, Pa s; rate_vp the engineering
// viscoplastic shear strain rate, 1/s. Limits: eta -> 0 is Tresca.

#include <cmath>

#include "solver/section/rate.hpp"

namespace leda::solver {

/// Shear stress while it flows, Pa.
inline double flow_stress(const BinghamFlow& law, double yield_Pa, double rate) {
  return yield_Pa + law.viscosity_Pa_s * std::abs(rate);
}

/// Viscoplastic shear rate under a stress, 1/s: zero up to the yield stress.
inline double flow_rate(const BinghamFlow& law, double yield_Pa, double stress_Pa) {
  const double over = std::abs(stress_Pa) - yield_Pa;
  return over <= 0 ? 0 : over / law.viscosity_Pa_s;
}

}  // namespace leda::solver
