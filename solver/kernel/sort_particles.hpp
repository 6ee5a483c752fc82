#pragma once
// Particles in the order of the cells they see, so that the kernels walk through memory.

#include "solver/kernel/grid.hpp"
#include "solver/kernel/particles.hpp"

namespace leda::solver {

/// Sorts by column and row of the lowest node seen (stable, so the order is the same every time)
/// and sets grid.top to the rows in use, with one cell to spare upwards and sideways.
/// @return false where a particle has left the grid; nothing is changed then
bool sort_particles(Particles& particles, Grid& grid);

}  // namespace leda::solver
