#pragma once
// omega of eq. 3-21: energy left for movement over retrogression, as a line over I_L m.

namespace leda::solver {

/// omega = intercept + slope I_L m, with I_L m in kN/m3 and omega in kPa per metre.
struct OmegaLine {
  double intercept = 0;
  double slope = 0;
  double spread = 0;  ///< standard deviation of the residuals, n - 2 degrees of freedom
  double r_squared = 0;

  double at(double liquidity_index, double unit_weight) const {
    return intercept + slope * liquidity_index * unit_weight / 1000;
  }
};

/// Eq. 3-21 as printed, fitted by the thesis to the energies of Table 3-5. Its spread is that of
/// the thesis's own five sites about it.
OmegaLine omega_thesis();

/// Least squares over the same five sites (Tables 3-3, 3-4, 3-6) with the right remolding energies.
OmegaLine omega_corrected();

}  // namespace leda::solver
