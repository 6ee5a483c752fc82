#pragma once
// The numbers of a particle that go into result files: one table for writing and reading.

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/section/frame.hpp"

namespace leda::db {

struct FrameField {
  const char* name;
  const char* unit;
  const char* meaning;
  std::vector<float> Frame::*values;
};

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
  for (const FrameField& field : frame_fields)
    if ((frame.*field.values).size() != frame.x.size())
      throw std::invalid_argument(std::string("frame: ") + field.name + " has " +
                                  std::to_string((frame.*field.values).size()) +
                                  " entries, x has " + std::to_string(frame.x.size()));
  if (frame.material.size() != frame.x.size())
    throw std::invalid_argument("frame: material has " + std::to_string(frame.material.size()) +
                                " entries, x has " + std::to_string(frame.x.size()));
}

}  // namespace leda::db
