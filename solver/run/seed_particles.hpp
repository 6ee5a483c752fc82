#pragma once
// A section to particles: a regular lattice under the ground, in geostatic stress.

#include <vector>

#include "solver/kernel/grid.hpp"
#include "solver/materials/law_table.hpp"
#include "solver/run/sampled_fields.hpp"
#include "solver/section/run_settings.hpp"
#include "solver/section/section.hpp"

namespace leda::solver {

struct Seeded {
  Particles particles;
  LawTable laws;
  GridSize size;
  bool averages = false;       ///< some ground is nearly incompressible
  std::vector<float> start_x;  ///< by id, m from the grid's origin
  double origin_x = 0;         ///< the section's x of the grid's origin; its z is the base
  double origin_z = 0;
  double spacing = 0;                ///< of particles, m
  std::vector<SampledField> fields;  ///< of materials whose strength varies within the ground
};

/// Particles on a square lattice, those whose centre lies under ground. Total stress from
/// effective K0: vertical = weight of the layers above, horizontal (both) =
/// K0 (vertical - u) + u with u of the water table. K0 on total stress instead would put more
/// than half of a soft clay plain above its peak strength before anything happens. Random fields
/// of strength are sampled where the lattice stands, for the seed of the resolution.
Seeded seed_particles(const Section& section, const Resolution& resolution);

}  // namespace leda::solver
