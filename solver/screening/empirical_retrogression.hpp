#pragma once
// Retrogression by the empirical formulas of thesis 3.5.2, m. A formula outside its range is
// refused with the reason instead of returning a number.

#include <array>
#include <optional>
#include <string>

#include "solver/screening/retrogression_fit.hpp"

namespace leda::solver {

struct Estimate {
  std::optional<double> metres;
  std::optional<std::array<double, 2>> range;  ///< with omega one spread higher and lower
  std::string why_not;                         ///< where absent
};

/// Eq. 3-22: RD = (E_P - E_R) / omega. The energy and the line must belong together: the thesis
/// reading with omega_thesis(), the right energy with omega_corrected().
/// Refused where omega <= 0 or nothing is left of E_P.
Estimate urmi_2023(double potential_J, double remolding_J, double liquidity_index,
                   double unit_weight, const OmegaLine& line);

/// H / (6 sin A) (Quinn et al. 2011; Table 3-7).
double quinn_2011(double height_m, double slope_angle_deg);

/// 4 H to 27 H (Carson and Lajoie 1981; Table 3-7).
std::array<double, 2> carson_lajoie_1981(double height_m);

/// 100 (N_s - 4), none below N_s = 6 (Mitchell and Markell 1974; Table 3-7).
Estimate mitchell_markell_1974(double stability_number);

/// 15 H: a line of 1V:15H from the toe (NVE; Table 3-7).
double nve_1_15(double height_m);

}  // namespace leda::solver
