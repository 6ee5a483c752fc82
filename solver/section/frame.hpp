#pragma once
// A snapshot of the particles: one entry a particle in every array, in the order of their seeding.

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
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

/// A number of the particles, as result files, views and checkpoints name it.
struct FrameField {
  const char* name;
  const char* unit;
  const char* meaning;
  std::vector<float> Frame::*values;
};

/// Every number of a frame: the one table that result files, views and checkpoints follow.
inline constexpr std::array<FrameField, 11> frame_fields = {{
    {"x", "m", "distance along the section", &Frame::x},
    {"z", "m", "elevation", &Frame::z},
    {"velocity_x", "m/s", "velocity along the section", &Frame::velocity_x},
    {"velocity_z", "m/s", "velocity upwards", &Frame::velocity_z},
    {"stress_xx", "Pa", "total stress, tension positive", &Frame::stress_xx},
    {"stress_zz", "Pa", "total stress, tension positive", &Frame::stress_zz},
    {"stress_xz", "Pa", "shear stress", &Frame::stress_xz},
    {"stress_yy", "Pa", "total stress across the section, tension positive", &Frame::stress_yy},
    {"plastic_strain", "1", "plastic engineering shear strain", &Frame::plastic_strain},
    {"strength", "Pa", "undrained shear strength now", &Frame::strength},
    {"volume", "m3/m", "volume per metre of width", &Frame::volume},
}};

/// Throws std::invalid_argument unless every array of the frame has one entry a particle.
inline void require_equal_lengths(const Frame& frame) {
  const auto require = [&](const char* name, std::size_t entries) {
    if (entries == frame.x.size()) return;
    throw std::invalid_argument(std::string("frame: ") + name + " has " + std::to_string(entries) +
                                " entries, x has " + std::to_string(frame.x.size()));
  };
  for (const FrameField& field : frame_fields) require(field.name, (frame.*field.values).size());
  require("material", frame.material.size());
}

}  // namespace leda
