#pragma once
// Strength at rest plus a viscous share: solid and debris by one formula.
//
//   s_u = [1 + eta (rate / rate_ref)^n] s_u,ref
//
// Source: Zhu and Randolph, thesis eqs 2-8, 2-9 (Wang et al. use it as f_2 of eq. 2-4) and 2-13
// (Shan et al., who take eta = 0.028 s_up[kPa]^0.28 and n 0.4 to 0.6).
// Parameters: eta >= 0, 0 < n <= 1; rate_ref > 0, 1/s; rate the engineering shear strain rate.
// Limits: factor 1 at rest, 1 + eta at the reference rate; nothing has to be cut off.

#include <cmath>

#include "solver/section/rate.hpp"

namespace leda::solver {

inline double strength_factor(const AdditivePowerRate& law, double rate) {
  return 1 + law.viscosity * std::pow(std::abs(rate) / law.reference_rate, law.exponent);
}

}  // namespace leda::solver
