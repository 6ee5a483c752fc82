#pragma once
// Points that have left their home cell are put into their new one.

#include "solver/kernel/grid.hpp"

namespace leda::solver {

/// Puts every stray, with its motion, into a free lane of its new cell, or into a pack of its
/// group's reserve; where that is used up the packs of that group are made anew.
/// @return false where a point has left the grid; nothing is changed then
template <class Real>
bool rehome_strays(Packs<Real>& packs, Grid<Real>& grid);

}  // namespace leda::solver
