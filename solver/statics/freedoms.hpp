#pragma once
// The unknowns of the static problem: which nodes may move, numbered column by column.

#include <cstdint>
#include <vector>

#include "solver/kernel/grid.hpp"

namespace leda::solver {

/// What moves a node along one axis: `sign` times unknown `number`, or nothing (-1: held).
struct Freedom {
  std::int32_t number = -1;
  double sign = 0;
};

/// Unknowns run column by column from left to right, upwards in each, x before z: a particle
/// joins three columns of nodes, so every coupling lies within two columns.
struct Freedoms {
  std::size_t rows = 0;              ///< of the grid
  std::vector<Freedom> of;           ///< [columns][rows][2 axes]
  std::vector<std::int32_t> first;   ///< of each column of the grid, and one past the last
  std::vector<std::int32_t> row_of;  ///< of the node that an unknown moves

  std::int32_t count() const { return first.back(); }
  const Freedom* at(std::size_t column, std::size_t row) const {
    return &of[(column * rows + row) * 2];
  }
  Freedom* at(std::size_t column, std::size_t row) { return &of[(column * rows + row) * 2]; }
};

/// Numbers the nodes that carry mass; edges and ghost nodes as in kernel/grid_update-inl.hpp.
/// @pre a balance of the nodes has left their masses in the grid
Freedoms number_freedoms(Grid<double>& grid);

/// Puts a displacement of the unknowns (m) on the nodes as a velocity, ghost nodes included.
void set_displacement(const Freedoms& freedoms, const double* displacement, Grid<double>& grid);

/// Unbalanced force on each unknown (N per metre), as a balance of the nodes leaves it in the grid.
void gather_force(const Freedoms& freedoms, Grid<double>& grid, double* force);

}  // namespace leda::solver
