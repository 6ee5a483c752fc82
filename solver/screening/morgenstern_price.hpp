#pragma once
// Morgenstern and Price (1965) and Spencer (1967): forces and moments of every slice.

#include <vector>

#include "solver/screening/slip_surface.hpp"

namespace leda::solver {

enum class Interslice {
  constant,  ///< Spencer: all interslice forces parallel
  half_sine  ///< Morgenstern-Price with f(x) = sin(pi x)
};

/// Solved as Zhu, Lee, Qian and Chen (2005, Canadian Geotechnical Journal 42, 272-278) write it:
///   E_i Phi_i = E_(i-1) Phi'_i + F T_i - R_i  (Phi' is Phi of slice i at its upper edge),
/// with lambda found by bracketing the balance of moments
///   sum b (E_i + E_(i-1)) tan a = lambda sum b (f_i E_i + f_(i-1) E_(i-1)).
/// @return infinity where no lambda between -3.2 and 3.2 balances forces and moments
double morgenstern_price(const std::vector<Slice>& slices, Interslice shape);

}  // namespace leda::solver
