#pragma once
// Strength is a power of the shear rate.
//
//   s_u = (rate / rate_ref)^b s_u,ref
//
// Source: thesis eq. 2-6 (after Einav and Randolph 2005); with softening eq. 2-15 (Tran and
// Solowski). Parameters: b 0.05 to 0.1; rate_ref > 0, 1/s; rate the engineering shear strain rate.
// Limits: the formula gives no strength at rest. s_u,ref is the strength of a quasi-static test, so
// the factor is held at 1 below rate_ref: ground at rest keeps its strength.

#include <algorithm>
#include <cmath>

#include "solver/section/rate.hpp"

namespace leda::solver {

inline double strength_factor(const PowerRate& law, double rate) {
  return std::pow(std::max(1.0, std::abs(rate) / law.reference_rate), law.exponent);
}

}  // namespace leda::solver
