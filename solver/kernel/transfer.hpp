#pragma once
// Particles to grid and back: quadratic B-splines (Steffen et al. 2008) with APIC (Jiang et al.
// 2015). Internal force and strain use the true gradients of the splines and are conjugate:
// sum_i f_i . v_i = - sum_p V sigma : grad v. The cheaper gradient of MLS-MPM (Hu et al. 2018)
// was tried and smears the shear bands: solver/README.md, "Choices".
// Where the grid averages, dilation and the mean of the in-plane normal stresses enter as their
// means over each span (B-bar, Hughes 1980), which leaves the pair conjugate: with spans s,
// sum V p_s div v = sum V_s p_s (div v)_s = sum V p (div v)_s.

#include "solver/kernel/grid.hpp"
#include "solver/kernel/particles.hpp"
#include "solver/materials/law_table.hpp"

namespace leda::solver {

/// Adds mass, momentum and internal force of every particle to the nodes it sees.
/// @pre particles lie where grid.top has rows for them
void particles_to_grid(const Particles& particles, Grid& grid);

/// What one pass over the particles adds up.
struct ParticleSums {
  double stress_work = 0;  ///< J per metre: stress power of the step, mid-step stress
  double momentum_x = 0, momentum_z = 0;  ///< kg m/s per metre
  double fastest_squared = 0;             ///< largest |v|^2, m2/s2
};

/// Takes velocity and its gradient from the grid, updates stress and plastic strain (Jaumann
/// rate, 3D Tresca), and moves the particles where `move` is set.
/// @pre where the grid averages: particles_to_grid was called on these positions
ParticleSums grid_to_particles(Particles& particles, Grid& grid, const LawTable& laws, double dt,
                               bool move);

}  // namespace leda::solver
