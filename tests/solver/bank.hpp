#pragma once
// A simple bank of one sensitive clay, for tests of whole runs.

#include <cmath>
#include <numbers>

#include "solver/section/run_settings.hpp"
#include "solver/section/section.hpp"

namespace leda::solver::test {

/// Plateau of 40 m, a bank falling to the right, 30 m of floor; base 3 m below the toe.
inline Section bank(double height, double angle_deg, double peak_strength) {
  const double run = height / std::tan(angle_deg * std::numbers::pi / 180);
  Section s;
  s.name = "bank";
  s.ground = {{0, height}, {40, height}, {40 + run, 0}, {70 + run, 0}};
  s.base_m = -3;
  s.water_table = WaterTable{0.0, {}};
  Material clay;
  clay.unit_weight = 17e3;
  clay.shear_modulus_Pa = 100 * peak_strength;
  clay.poisson_ratio = 0.45;
  clay.peak_strength.constant_Pa = peak_strength;
  UrmiSoftening law;
  law.alpha = 0.95;
  law.beta = 2.8;
  law.residual_strain = 1.8;
  law.remolded_strength_Pa = 0.02 * peak_strength;
  clay.softening = Softening{law, 0.014, Regularization::beta};
  s.materials["clay"] = clay;
  Layer layer;
  layer.material = "clay";
  s.layers = {layer};
  return s;
}

inline RunSettings coarse() {
  RunSettings settings;
  settings.resolution.cell_m = 1;
  settings.stop.max_time_s = 40;
  return settings;
}

}  // namespace leda::solver::test
