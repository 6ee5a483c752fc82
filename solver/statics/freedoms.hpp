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
  std::vector<Freedom> of;           ///< [columns][rows][2 axes]
  std::vector<std::int32_t> first;   ///< of each column of the grid, and one past the last
  std::vector<std::int32_t> row_of;  ///< of the node that an unknown moves

  std::int32_t count() const { return first.back(); }
  const Freedom* at(const Grid& grid, std::size_t column, std::size_t row) const {
    return &of[grid.index(column, row) * 2];
  }
};

/// Numbers the nodes that carry mass; edges and image nodes as in boundary.hpp.
/// @pre particles_to_grid and update_velocity have left the nodes' masses in the grid
Freedoms number_freedoms(const Grid& grid);

/// Spreads a displacement of the unknowns (m) to grid.velocity, images included.
void set_displacement(const Freedoms& freedoms, const double* displacement, Grid& grid);

/// Unbalanced force on each unknown (N per metre), as update_velocity leaves it in the grid.
void gather_force(const Freedoms& freedoms, const Grid& grid, double* force);

}  // namespace leda::solver
