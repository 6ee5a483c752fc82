#include "solver/extremes/banks.hpp"

#include <cmath>
#include <numbers>

namespace leda::solver {

Material plain_clay(double peak_strength_Pa) {
  Material clay;
  clay.unit_weight = 17e3;
  clay.shear_modulus_Pa = 100 * peak_strength_Pa;
  clay.poisson_ratio = 0.45;
  clay.peak_strength.constant_Pa = peak_strength_Pa;
  return clay;
}

Material sensitive_clay(double peak_strength_Pa, double remolded_strength_Pa) {
  Material clay = plain_clay(peak_strength_Pa);
  UrmiSoftening law;
  law.alpha = 0.95;
  law.beta = 2.8;
  law.residual_strain = 1.8;
  law.remolded_strength_Pa = remolded_strength_Pa;
  clay.softening = Softening{law, 0.014, Regularization::beta};
  return clay;
}

Material moderate_clay(double peak_strength_Pa) {
  Material clay = sensitive_clay(peak_strength_Pa, 0.35 * peak_strength_Pa);
  std::get<UrmiSoftening>(clay.softening->law).residual_strength_Pa = 0.35 * peak_strength_Pa;
  clay.softening->regularization = Regularization::none;
  return clay;
}

Section bank_of_clay(const BankShape& shape, const Material& clay) {
  const double run = shape.height_m / std::tan(shape.angle_deg * std::numbers::pi / 180);
  const double crest = shape.plateau_m, toe = shape.plateau_m + run;
  Section s;
  s.name = "bank";
  s.ground = {{0, shape.height_m}, {crest, shape.height_m}, {toe, 0}, {toe + shape.floor_m, 0}};
  s.base_m = -shape.below_toe_m;
  s.water_table = WaterTable{0.0, {}};
  s.materials["clay"] = clay;
  Layer layer;
  layer.material = "clay";
  s.layers = {layer};
  return s;
}

Section vertical_cut_of_clay(double poisson_ratio) {
  const double height = 20;
  Material clay = plain_clay(17e3 * height / 4);
  clay.shear_modulus_Pa = 300 * clay.peak_strength.constant_Pa;
  clay.poisson_ratio = poisson_ratio;
  clay.k0 = 1;
  Section s = bank_of_clay({.height_m = height}, clay);
  s.ground = {{0, height}, {50, height}, {50.001, 0}, {100, 0}};
  s.base_m = -10;
  s.water_table.reset();
  return s;
}

RunSettings settings_of(double cell_m, double max_time_s) {
  RunSettings settings;
  settings.resolution.cell_m = cell_m;
  settings.stop.max_time_s = max_time_s;
  settings.output.frame_interval_s = 1;
  return settings;
}

}  // namespace leda::solver
