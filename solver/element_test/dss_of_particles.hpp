#pragma once
// Direct simple shear by the solver itself: particles of one cell, moved by the grid.

#include "solver/element_test/dss.hpp"
#include "solver/section/material.hpp"

namespace leda::solver {

struct ParticleShear {
  double cell_m = 0;                  ///< height of the specimen: one cell
  int particles_per_cell = 4;         ///< a square
  double vertical_stress_Pa = 0;      ///< consolidated under this, horizontal k0 times it; > 0
  std::optional<double> max_strain;   ///< as in dss_of_bare_law
  double rate = standard_shear_rate;  ///< 1/s; matters where the material has a rate or flow law
};

/// Shears one cell of particles as the thesis does (4.4: an element as high as the specimen, the
/// top moved, the base held). All nodes such an element has lie on the base or the top, so every
/// node that a particle sees is given the velocity of simple shear; gradient, Jaumann rate, return
/// to the Tresca surface and softening are those of grid_to_particles(). Inertia plays no part: the
/// test is slow (0.01 mm/s) against a shear wave.
/// Under a vertical stress and K0 below 1 the first shear stress at yield is below s_up, because
/// (sigma_v - sigma_h)/2 is shear too.
/// @param peak_Pa s_up at the place of the specimen
DssCurve dss_of_particles(const Material& material, double peak_Pa, const ParticleShear& test);

}  // namespace leda::solver
