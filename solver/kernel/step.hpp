#pragma once
// One explicit step of the material point method.

#include "solver/kernel/grid_update.hpp"
#include "solver/kernel/transfer.hpp"

namespace leda::solver {

struct StepSettings {
  double dt = 0;
  double gravity = 0;
  double damping = 0;
  bool move = true;  ///< false: positions stay (initial stress)
  bool ground_rests = true;
};

struct StepSums {
  GridSums grid;
  ParticleSums particles;
};

/// Advances velocity, stress and position by dt (symplectic Euler, update stress last).
/// @pre particles were sorted, and none has moved by more than a cell since
StepSums step(Particles& particles, Grid& grid, const LawTable& laws, const StepSettings& settings);

}  // namespace leda::solver
