#pragma once
// A snapshot of the particles: one entry a particle in every array, in the order of their seeding.

#include <cstdint>
#include <vector>

namespace leda {

struct Frame {
  double time_s = 0;
  std::vector<float> x, z;                                        ///< m
  std::vector<float> velocity_x, velocity_z;                      ///< m/s
  std::vector<float> stress_xx, stress_zz, stress_xz, stress_yy;  ///< Pa, tension positive
  std::vector<float> plastic_strain;   ///< engineering shear strain, fraction
  std::vector<float> strength;         ///< s_u now, Pa
  std::vector<float> volume;           ///< m3 per metre of width
  std::vector<std::int32_t> material;  ///< index in the section's materials, by name
};

}  // namespace leda
