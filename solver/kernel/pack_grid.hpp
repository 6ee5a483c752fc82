#pragma once
// The background grid of the packs: sums and velocities by column, each value a run of memory.

#include <cstddef>
#include <vector>

#include "solver/kernel/grid_update.hpp"
#include "solver/kernel/packs.hpp"

namespace leda::solver {

/// Nodes as in Grid. What points in home row k give to node row k + j stands in plane j at k, so
/// that a pack adds to aligned places that no other home row touches; the three planes of a value
/// are added up when the nodes are updated.
struct PackGrid {
  static constexpr std::size_t values = 5;  ///< mass, momentum x z, force x z
  static constexpr std::size_t planes = 3;
  static constexpr std::size_t lead = 8;  ///< zeros below row 0

  double h = 0;
  std::size_t columns = 0, rows = 0;
  std::size_t stride = 0;        ///< of a plane
  std::vector<Real> sums;        ///< [columns][values][planes][stride]
  std::vector<Real> velocity;    ///< [columns][x z][stride]
  std::vector<Real> mass;        ///< [columns][stride] of the last update; empty where not kept
  std::vector<std::size_t> top;  ///< rows in use in each column

  Real* sums_at(std::size_t column, std::size_t row) {
    return &sums[column * values * planes * stride + lead + row];
  }
  Real* velocity_at(std::size_t column, std::size_t row) {
    return &velocity[column * 2 * stride + lead + row];
  }
  Real* mass_at(std::size_t column, std::size_t row) { return &mass[column * stride + lead + row]; }
};

/// Groups of columns there are.
inline std::size_t groups_of(const PackGrid& grid) {
  return (grid.columns + columns_of_a_group - 1) / columns_of_a_group;
}

PackGrid make_pack_grid(const Grid& grid, bool keeps_mass = false);

/// The momentum balance on the nodes of columns `first` to `last` - 1, as update_velocity does it
/// (the image columns go with the column they mirror). The sums are zero afterwards. Of the sums
/// returned, weight and unbalanced force are left out.
/// @pre 1 <= first, last <= columns - 1
GridSums update_columns(PackGrid& grid, const GridStep& step, std::size_t first, std::size_t last);

}  // namespace leda::solver
