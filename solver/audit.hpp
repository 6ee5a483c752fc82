#pragma once
// Mass, momentum and energy of a run: what the numbers themselves say about it.

#include "solver/section/section_result.hpp"
#include "solver/step.hpp"

namespace leda::solver {

/// Energy by parts since the stage began, J per metre of width. With symplectic Euler and
/// conjugate transfers, kinetic + stress work - gravity work - damping work + transfer loss is
/// constant but for the discretisation of time; the difference is the energy error.
struct EnergyAudit {
  double kinetic_start = 0, kinetic = 0, kinetic_peak = 0;
  double gravity_work = 0;
  double damping_work = 0;
  double stress_work = 0;
  double transfer_loss = 0;  ///< kinetic energy below the grid's resolution, lost by APIC
  double least_scale = 0;    ///< weight of the ground times a thousandth of a cell
  bool started = false;

  void add(const StepSums& sums, const StepSettings& step);
  /// What errors are measured against: the largest of the works done and the peak of motion.
  double scale() const;
  double error() const;                  ///< relative to scale()
  double numerical_dissipation() const;  ///< transfer loss over scale()
};

EnergyAudit begin_audit(const Particles& particles, double h);

/// Relative difference of mass and momentum between particles and nodes after one transfer.
/// The grid is left as particles_to_grid leaves it.
Balances transfer_balance(const Particles& particles, Grid& grid);

}  // namespace leda::solver
