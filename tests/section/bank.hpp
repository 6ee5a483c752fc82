#pragma once
// The section most tests start from: sound, so that a test changes the one thing it looks at.
//
//   20 -----------.                      crust, 2 m
//                  `.                    clay down to 5 m
//                    `.
//    5                 `-----------      clay2 down to the base
//    0 ============================
//      0         40     70        100

#include "solver/section/run_settings.hpp"
#include "solver/section/section.hpp"

namespace leda::test {

inline Material elastic_plastic() {
  Material m;
  m.unit_weight = 18e3;
  m.shear_modulus_Pa = 3e6;
  m.poisson_ratio = 0.45;
  m.peak_strength.constant_Pa = 90e3;
  return m;
}

inline Material softening_clay() {
  Material m = elastic_plastic();
  m.unit_weight = 17e3;
  m.peak_strength.constant_Pa = 40e3;
  UrmiSoftening law;
  law.alpha = 0.95;
  law.beta = 2.8;
  law.residual_strain = 1.8;
  law.remolded_strength_Pa = 1e3;
  m.softening = Softening{law, 0.014, Regularization::beta};
  return m;
}

inline Layer layer(const char* material) {
  Layer l;
  l.material = material;
  return l;
}

inline Section bank() {
  Section s;
  s.name = "bank";
  s.ground = {{0, 20}, {40, 20}, {70, 5}, {100, 5}};
  s.base_m = 0;
  s.water_table = WaterTable{0.0, {}};
  s.layers = {layer("crust"), layer("clay"), layer("clay2")};
  s.layers[0].thickness_m = 2;
  s.layers[1].bottom_m = 5;
  s.materials = {
      {"crust", elastic_plastic()}, {"clay", softening_clay()}, {"clay2", softening_clay()}};
  return s;
}

}  // namespace leda::test
