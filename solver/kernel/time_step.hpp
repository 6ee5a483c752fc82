#pragma once
// The explicit time step.

#include <limits>

#include "solver/section/run_settings.hpp"

namespace leda::solver {

/// Courant limit for waves on moving ground: factor h / (c_p + |v|). With quadratic B-splines a
/// factor of 0.5 is safe and 0.9 is not (lumped mass: the highest grid mode has w = 2 c_p / h,
/// and near a free edge lighter nodes raise it).
/// @param h cell, m  @param wave_speed c_p, m/s  @param fastest particle speed, m/s
inline double time_step(double h, double wave_speed, double fastest, double factor) {
  return factor * h / (wave_speed + fastest);
}

/// The longest step, of h / c_p, that ground as it is can take: 0.7 was stable in all of leda
/// check.
inline constexpr double most_factor_unsoftened = 0.65;

/// Whether steps are so long that ground which would limit them has to be softer (PackLaws). With
/// one particle a cell all of the ground limits them: on borders of splines the highest mode has w
/// = 2 c_p / h.
inline bool takes_long_steps(const RunSettings& settings) {
  return settings.time_step_factor > most_factor_unsoftened &&
         settings.resolution.particles_per_cell > 1;
}

/// The longest step, of h / c_p, that a moving stage takes; `softer` as in PackLaws. What a case
/// may ask for, validation says.
inline double most_factor(bool softer) {
  return softer ? std::numeric_limits<double>::infinity() : most_factor_unsoftened;
}

}  // namespace leda::solver
