#pragma once
// Material points into packs and back.

#include "solver/packs/pack_grid.hpp"
#include "solver/packs/packs.hpp"

namespace leda::solver {

/// Packs of all particles, with their motion; sets grid.top to the rows in use, with one cell to
/// spare upwards and sideways. The same particles in the same order give the same packs.
/// @return false where a particle lies outside the grid
bool pack(const Particles& particles, PackGrid& grid, Packs& packs);

/// Puts every point into the cell it has moved to. The motion is not kept.
/// @return false where a point has left the grid; nothing is changed then
bool rearrange(Packs& packs, PackGrid& grid);

/// Finds the groups of packs that stand in their places.
void find_groups(Packs& packs, const PackGrid& grid);

/// Writes where the points are to the particles they came from.
void unpack_positions(const Packs& packs, const PackGrid& grid, Particles& particles);

/// Writes what the packs hold to the particles they came from.
/// @pre the last step kept the motion
void unpack(const Packs& packs, const PackGrid& grid, Particles& particles);

}  // namespace leda::solver
