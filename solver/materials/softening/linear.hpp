#pragma once
// Linear from the peak to the remolded strength.
//
//   s_u = s_up - (s_up - s_ur) gamma / gamma_r      gamma < gamma_r
//   s_u = s_ur                                      gamma >= gamma_r
//
// Source: thesis eq. 2-1 (Wang, Vardon and Hicks 2016, with K = -(s_up - s_ur)/gamma_r) and eq.
// 2-11 (Zhang et al.). Parameters: gamma_r > 0, fraction. Limits: s_up at zero, s_ur from gamma_r
// on.

#include <algorithm>

#include "solver/materials/softening_curve.hpp"
#include "solver/section/material.hpp"

namespace leda::solver {

inline SofteningCurve curve_of(const LinearSoftening& law, double peak_Pa) {
  return {.peak = peak_Pa,
          .floor = peak_Pa,
          .amplitude = 0,
          .rate = 0,
          .exp_end = 0,
          .line_start = peak_Pa,
          .line_end = law.remolded_strain,
          .last = std::min(law.remolded_strength_Pa, peak_Pa)};
}

}  // namespace leda::solver
