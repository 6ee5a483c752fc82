#pragma once
// Smeared crack: the softening law of a specimen scaled so that a shear band one cell thick
// dissipates the energy that the band in the specimen dissipated (thesis 4.5, 5.4.1).

#include <optional>

#include "solver/materials/softening_curve.hpp"
#include "solver/section/material.hpp"

namespace leda::solver {

/// Energies are per area of shear band, N/m (divide by 1000 for kN/m).
struct Calibration {
  Regularization regularization = Regularization::beta;
  double cell_m = 0;
  double reference_size_m = 0;
  SofteningCurve reference;  ///< the law on its specimen
  SofteningCurve cell;       ///< the law in the cell, by the closed form

  double scale_closed_form = 1;  ///< cell / reference size; 1 without regularization

  /// Root of "energy in the cell = energy in the specimen". Absent without regularization, and
  /// where the law dissipates nothing that could be kept equal.
  std::optional<double> scale_numerical;

  /// For `beta`: as scale_numerical, but the area above s_uR is counted to gamma_R only, which is
  /// all a test can show. Absent where no scale gives that energy.
  std::optional<double> scale_to_residual_strain;

  double reference_excess = 0;  ///< above s_uR (or the last strength): what `beta` keeps equal
  double cell_excess = 0;
  double reference_total = 0;  ///< to the remolded strain; 0 for a law that has none
  double cell_total = 0;

  bool snaps_back = false;  ///< steepest loss in the cell exceeds G
  double steepest_loss_Pa = 0;
};

/// Scales a law to a cell, in closed form and by root finding.
/// @param shear_modulus_Pa G, for the check on snap-back alone
/// @param cell_m > 0
Calibration calibrate(const Softening& softening, double peak_Pa, double shear_modulus_Pa,
                      double cell_m);

}  // namespace leda::solver
