#pragma once
// A vertical cut in clay of one undrained strength that does not soften.

#include <string>

#include "solver/run/simulate.hpp"
#include "tests/verification/precision.hpp"

namespace leda::solver::test {

inline constexpr double cut_height = 20, cut_unit_weight = 17e3;

/// 50 m of plateau, the cut, 50 m of floor with 10 m of the same clay beneath it.
/// @param stability_number gamma H / s_u
inline Section vertical_cut(double stability_number, double poisson_ratio = 0.45) {
  Section s;
  s.name = "vertical cut";
  s.ground = {{0, cut_height}, {50, cut_height}, {50.001, 0}, {100, 0}};
  s.base_m = -10;
  Material clay;
  clay.unit_weight = cut_unit_weight;
  clay.peak_strength.constant_Pa = cut_unit_weight * cut_height / stability_number;
  clay.shear_modulus_Pa = 300 * clay.peak_strength.constant_Pa;
  clay.poisson_ratio = poisson_ratio;
  clay.k0 = 1;
  s.materials["clay"] = clay;
  Layer layer;
  layer.material = "clay";
  s.layers = {layer};
  return s;
}

/// Whether the cut finds no balance, or moves by more than the surface's threshold.
template <class Real>
bool cut_fails(double stability_number, double cell, double poisson_ratio = 0.45) {
  RunSettings settings = settings_in<Real>();
  settings.resolution.cell_m = cell;
  settings.stop.max_time_s = 15;
  const SectionResult r = simulate(vertical_cut(stability_number, poisson_ratio), settings);
  return r.status != RunStatus::stable;
}

}  // namespace leda::solver::test
