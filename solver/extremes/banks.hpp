#pragma once
// Sections and clays that the extreme cases change one thing of.

#include "solver/section/run_settings.hpp"
#include "solver/section/section.hpp"

namespace leda::solver {

/// Plateau, a bank falling to the right, a floor at elevation 0; one material down to the base.
struct BankShape {
  double height_m = 10;
  double angle_deg = 45;
  double plateau_m = 30;
  double floor_m = 30;
  double below_toe_m = 3;
};

/// 17 kN/m3, G = 100 s_u, nu 0.45, K0 0.5; elastic and perfectly plastic.
Material plain_clay(double peak_strength_Pa);

/// The same clay, softening by Urmi's law (beta 2.8, scaled to the cell) to this remolded strength.
Material sensitive_clay(double peak_strength_Pa, double remolded_strength_Pa);

/// The same clay that keeps 0.35 of its strength and loses the rest slowly: one slide that stops.
Material moderate_clay(double peak_strength_Pa);

/// Water table at the ground.
Section bank_of_clay(const BankShape& shape, const Material& clay);

/// 50 m of plateau, a vertical cut of 20 m, 50 m of floor with 10 m of the same clay beneath it.
/// K0 = 1 and no water: the stress of a cut made at once in ground at rest.
Section vertical_cut_of_clay(double poisson_ratio);

RunSettings settings_of(double cell_m, double max_time_s);

}  // namespace leda::solver
