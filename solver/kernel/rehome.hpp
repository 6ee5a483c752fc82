#pragma once
// Points that change their cell, from pack to pack.

#include "solver/kernel/pack_grid.hpp"
#include "solver/kernel/packs.hpp"

namespace leda::solver {

/// Puts every stray into the cell it has moved to: into a free lane where there is one, into a pack
/// of the reserve otherwise; where there is none, the packs of that group are made anew. The motion
/// of strays is not kept, nor that of groups made anew.
/// @return false where a point has left the grid; nothing is changed then
bool rehome_strays(Packs& packs, PackGrid& grid);

}  // namespace leda::solver
