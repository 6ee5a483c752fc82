#pragma once
// Material points into packs and back.

#include "solver/kernel/pack_grid.hpp"
#include "solver/kernel/packs.hpp"

namespace leda::solver {

/// Whether what a point in this home cell sees, and one cell more, lies on the grid. False also for
/// what is not a number.
bool on_grid(const PackGrid& grid, double column, double row);

/// Packs of all particles, with their motion; sets grid.top to the rows in use, with one cell to
/// spare upwards and sideways. The same particles in the same order give the same packs.
/// @return false where a particle lies outside the grid
bool pack(const Particles& particles, PackGrid& grid, Packs& packs);

/// Writes what the packs hold to the particles they came from.
/// @pre the last step kept the motion
void unpack(const Packs& packs, const PackGrid& grid, Particles& particles);

}  // namespace leda::solver
