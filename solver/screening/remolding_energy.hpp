#pragma once
// The energy that remolds a clay, J/m3, by the complete softening curve and by its two shortcuts.

#include <optional>

#include "solver/screening/site.hpp"

namespace leda::solver {

/// s_uR = 0.095 s_up (eq. 3-11).
double residual_strength(double peak_strength_Pa);

/// gamma_r = 0.13 s_up gamma_R with s_up in kPa (eq. 3-13; the constant has the unit 1/kPa).
double remolded_strain(double peak_strength_Pa, double residual_strain);

/// The curve of eq. 3-10 after its peak:
/// s_u = s_uR + (s_up - s_uR) alpha exp(-beta gamma) up to gamma_R, then straight to s_ur at
/// gamma_r.
struct PostPeakCurve {
  double peak_Pa = 0, residual_Pa = 0, remolded_Pa = 0;
  double alpha = 1, beta = 0;  ///< beta per unit strain
  double peak_strain = 0, residual_strain = 0, remolded_strain = 0;
};

/// Absent: the site lacks the softening, the remolded strength or the peak strain (which eqs 3-3
/// and 3-5 give from the preconsolidation).
std::optional<PostPeakCurve> post_peak_curve(const Site& site);

/// Eqs 3-16 and 3-17 with the first integral ending at gamma_R, as in eqs 3-19 to 3-22:
/// s_uR (g_R - g_p) + (s_up - s_uR) alpha/beta (exp(-beta g_p) - exp(-beta g_R))
///   + (s_uR + s_ur)(g_r - g_R)/2. The curve is not clamped to s_up here, as in the thesis.
double remolding_energy(const PostPeakCurve& curve);

/// The same up to a share of the remolding, I_r = (s_up - s_u)/(s_up - s_ur) (eq. 3-1).
double energy_to_remolding_index(const PostPeakCurve& curve, double index);

/// What Table 3-5 prints: beta taken per per cent while strain is a fraction, and its sign turned,
/// so that the exponential grows. Wrong by a factor of 2 to 4.6; kept only because the
/// coefficients of eq. 3-21 were fitted to it.
double remolding_energy_thesis_reading(const PostPeakCurve& curve);

/// E_R = 16 s_up I_p (Leroueil et al. 1996; eq. 3-15).
double remolding_energy_leroueil(double peak_strength_Pa, double plasticity_index);

/// Thakur et al. (thesis 3.4.4, Figure 3-19a): the slope of the curve at the peak strain is held
/// straight down to s_ur; (s_up + s_ur)/2 times the strain that takes.
double remolding_energy_linear(const PostPeakCurve& curve);

}  // namespace leda::solver
