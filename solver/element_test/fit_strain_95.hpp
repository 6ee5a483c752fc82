#pragma once
// gamma_95 and gamma_r of the law of Einav and Randolph from one point of a partial curve
// (first appendix of the thesis, eqs 8 and 9).
//
//   gamma_95 = -3 gamma / ln[ (s_u/s_up - 1/S_t) / (1 - 1/S_t) ]      [8]
//   gamma_r  = 3 gamma_95                                             [9]
//
// The point is the one at 50 % of the loss, s_u = (s_up + s_ur)/2, or the last one where the test
// ends earlier (as the appendix does for Saint-Jude). The appendix's Table 2 puts (1 - 1/S_t)/2 for
// s_u50/s_up, which is a slip for (1 + 1/S_t)/2: its gamma_95 are low by 1 to 12 %.

#include <string>
#include <vector>

#include "solver/element_test/post_peak.hpp"
#include "solver/section/material.hpp"

namespace leda::solver {

/// Eq. 8 for any point of the curve.
/// @param strength_ratio s_u / s_up, between 1/S_t and 1
double strain_95(double strain, double strength_ratio, double sensitivity);

struct Strain95Fit {
  EinavRandolphSoftening law;
  double remolded_strain = 0;  ///< gamma_r, eq. 9
  double sensitivity = 0;      ///< S_t = s_up / s_ur
  double strain_used = 0;
  double reduction_used = 0;  ///< 0.5, or less where the test ended earlier
  Goodness goodness;          ///< of the law over all points behind the peak
  std::vector<std::string> warnings;
  std::vector<std::string> faults;  ///< not empty: the rest means nothing
};

Strain95Fit fit_strain_95(const PostPeak& curve, double remolded_Pa);

}  // namespace leda::solver
