#pragma once
// One step of the packs: from the nodes to the points and on to the nodes of the next step, in a
// single pass over memory.

#include "solver/kernel/pack_grid.hpp"
#include "solver/kernel/packs.hpp"
#include "solver/kernel/transfer.hpp"

namespace leda::solver {

struct PackSums {
  ParticleSums particles;   ///< momentum_x is left out
  std::size_t strayed = 0;  ///< points outside their home cell after the step
  bool left_grid = false;   ///< a point has gone where there are no nodes
  bool yields = false;      ///< a point has yielded in the step
};

/// Adds the points of packs `first` to `last` - 1 to the sums of the grid; finds the strays.
/// @pre packs.motion holds its motion
void spread(Packs& packs, PackGrid& grid, std::size_t first, std::size_t last);

/// As grid_to_particles, then as particles_to_grid (transfer.hpp), for laws without rate and flow.
/// For the packs `first` to `last` - 1; `keep`: packs.motion is written. Finds the
/// strays.
PackSums step_packs(Packs& packs, PackGrid& grid, const PackLaws& laws, double dt, bool keep,
                    std::size_t first, std::size_t last);

}  // namespace leda::solver
