#pragma once
// The edges of the model, by images: what lies within half a cell of an edge also reaches one
// node outside it, and that node is the image of the first node inside. Folding it back makes
// the spline space satisfy the edge condition exactly: at the sides the normal velocity is odd
// and the tangential one even (fixed horizontally), at the base both are odd (fixed both ways;
// held vertically alone, the whole bank would slide on it).

#include "solver/kernel/grid.hpp"

namespace leda::solver {

/// Adds the values of the image nodes to the nodes inside and holds the nodes on the edges.
void fold_images(Grid& grid);

/// Gives the image nodes the velocity that belongs to the nodes inside.
void mirror_velocity(Grid& grid);

}  // namespace leda::solver
