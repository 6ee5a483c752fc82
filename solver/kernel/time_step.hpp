#pragma once
// The explicit time step.

namespace leda::solver {

/// Courant limit for waves on moving ground: factor h / (c_p + |v|). With quadratic B-splines a
/// factor of 0.5 is safe and 0.9 is not (lumped mass: the highest grid mode has w = 2 c_p / h,
/// and near a free edge lighter nodes raise it).
/// @param h cell, m  @param wave_speed c_p, m/s  @param fastest particle speed, m/s
inline double time_step(double h, double wave_speed, double fastest, double factor) {
  return factor * h / (wave_speed + fastest);
}

}  // namespace leda::solver
