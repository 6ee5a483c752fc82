#pragma once
// The parameters of the law of Urmi et al. from a partial laboratory curve (thesis 3.4.3).
//
// 1. alpha and beta from (s_u - s_uR)/(s_up - s_uR) = alpha exp(-beta gamma), s_uR by eq. 3-11:
//    nonlinear least squares of the stress (Levenberg-Marquardt), which weighs a kilopascal alike
//    everywhere; the trend line of the thesis (least squares of the logarithm) starts it and is
//    reported beside it.
// 2. gamma_R, the strain "corresponding to s_uR on the plotted curve": where the test itself
// crosses
//    s_uR; else where the exponential is as close to s_uR as a share of (s_up - s_uR). It never
//    reaches s_uR, and the thesis reads gamma_R by eye at 0.26 to 0.62 % (Table 3-4). The median of
//    the seven sites, 0.33 %, gives their gamma_R within 13 %.
// 3. gamma_r by eq. 3-12 from points behind gamma_R where there are any; else by eq. 3-13.

#include <optional>
#include <string>
#include <vector>

#include "solver/element_test/post_peak.hpp"
#include "solver/section/material.hpp"

namespace leda::solver {

/// Median of alpha exp(-beta gamma_R) over the sites of thesis Table 3-4.
inline constexpr double residual_share_of_table_3_4 = 0.0033;

/// A curve that ends before this share of the loss does not bind beta.
inline constexpr double least_reduction = 0.30;

struct UrmiFitInput {
  PostPeak curve;
  double remolded_Pa = 0;             ///< s_ur
  std::optional<double> residual_Pa;  ///< s_uR; absent: eq. 3-11
  bool fit_residual = false;          ///< s_uR is a third unknown
  double residual_share = residual_share_of_table_3_4;
};

struct UrmiFit {
  UrmiSoftening law;  ///< every optional of it filled
  double alpha_error = 0;
  double beta_error = 0;  ///< standard errors of the least squares
  double alpha_trend_line = 0;
  double beta_trend_line = 0;
  bool residual_strain_from_test = false;  ///< else step 2's share
  bool remolded_strain_from_test = false;  ///< else eq. 3-13
  double reduction = 0;                    ///< share of the loss that the test reached
  std::size_t points_fitted = 0;           ///< those above s_uR
  Goodness goodness;                       ///< of the whole law over all points behind the peak
  std::vector<std::string> warnings;
  std::vector<std::string> faults;  ///< not empty: the rest means nothing
};

UrmiFit fit_urmi(const UrmiFitInput& input);

}  // namespace leda::solver
