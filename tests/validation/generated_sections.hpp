#pragma once
// Banks drawn at random from a seed: heights, angles, strengths, layers and water as they occur in
// sensitive clays. The same seed gives the same section on every machine.

#include <cstdint>

#include "solver/section/run_settings.hpp"
#include "solver/section/section.hpp"

namespace leda::test {

struct GeneratedCase {
  Section section;
  RunSettings settings;
  double height_m = 0, angle_deg = 0, strength_Pa = 0, water_depth_m = 0;
  double toe_cut_m = 0;  ///< 0: none asked for
};

/// @param cells_per_height how many cells a bank is high
GeneratedCase generate_case(std::uint64_t seed, double cells_per_height);

}  // namespace leda::test
