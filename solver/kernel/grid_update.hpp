#pragma once
// Momentum balance on the nodes: gravity, local damping, edges, new velocity.

#include "solver/kernel/grid.hpp"

namespace leda::solver {

struct GridStep {
  double dt = 0;       ///< s
  double gravity = 0;  ///< m/s2, downwards
  double damping = 0;  ///< local damping: this share of the unbalanced force, against motion
};

/// Energies in J and forces in N, per metre of width.
struct GridSums {
  double kinetic_before = 0;  ///< of the nodes, before the forces act
  double kinetic_after = 0;
  double damping_work = 0;      ///< done by damping, <= 0
  double unbalanced_force = 0;  ///< sum of |internal + gravity| over the nodes
  double weight = 0;            ///< sum of |gravity|
};

/// Fills grid.velocity. Damping is that of Cundall 1987 as Anura3D has it:
/// f_d = -damping |f| sign(v), each axis by itself.
GridSums update_velocity(Grid& grid, const GridStep& step);

}  // namespace leda::solver
