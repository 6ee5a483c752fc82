#pragma once
// Strength grows by the same share of itself with every decade of the shear rate.
//
//   s_u = [1 + mu log10(rate / rate_ref)] s_u,ref
//
// Source: thesis eq. 2-5 ("proportional change for each order of magnitude": log to base 10).
// Parameters: mu 0.05 to 0.2; rate_ref > 0, 1/s; rate the engineering shear strain rate, 1/s.
// Limits: below rate_ref the formula falls without end and turns negative. s_u,ref is the strength
// of a quasi-static test, so the factor is held at 1 there (as Zhou and Randolph 2007 do).

#include <algorithm>
#include <cmath>

#include "solver/section/rate.hpp"

namespace leda::solver {

inline double strength_factor(const SemiLogarithmicRate& law, double rate) {
  const double relative = std::max(1.0, std::abs(rate) / law.reference_rate);
  return 1 + law.per_decade * std::log10(relative);
}

}  // namespace leda::solver
