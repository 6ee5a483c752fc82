#pragma once
// Particles into packs and back.

#include "solver/kernel/grid.hpp"

namespace leda::solver {

/// Whether what a point in this home cell sees, and one cell more, lies on the grid. False also for
/// what is not a number.
template <class Real>
bool on_grid(const Grid<Real>& grid, double column, double row);

/// Packs of all particles, with their motion; sets grid.top to the rows in use, with one cell to
/// spare upwards and sideways. The same particles in the same order give the same packs.
/// @return false where a particle lies outside the grid
template <class Real>
bool pack(const Particles& particles, Grid<Real>& grid, Packs<Real>& packs);

/// The points as particles, in the order of their ids.
/// @pre packs.motion holds their motion
template <class Real>
Particles unpack(const Packs<Real>& packs, double h);

}  // namespace leda::solver
