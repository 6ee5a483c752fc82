#pragma once
// Mass, momentum and energy of a run: what the numbers themselves say about it.

#include "solver/run/model_of_run.hpp"
#include "solver/section/section_result.hpp"

namespace leda::solver {

/// Energy by parts since the stage began, J per metre of width. With symplectic Euler and
/// conjugate transfers, kinetic + stress work - gravity work - damping work + transfer loss is
/// constant but for the discretisation of time; the difference is the energy error. Plastic work,
/// stress work less the growth of elastic energy, can only be positive: where it is not, the
/// stress update feeds energy.
struct EnergyAudit {
  double kinetic_start = 0, kinetic = 0, kinetic_peak = 0;
  double gravity_work = 0;
  double damping_work = 0;
  double stress_work = 0;
  double transfer_loss = 0;  ///< kinetic energy below the grid's resolution, lost by APIC
  double elastic_start = 0;
  double least_scale = 0;  ///< weight of the ground times a thousandth of a cell
  bool started = false;

  void add(const StepSums& sums, const StepSettings& step);
  /// What errors are measured against: the largest of the works done and the peak of motion.
  double scale() const;
  double residual() const;  ///< over scale(); positive: energy out of nothing
  /// Plastic work over scale(), given the elastic energy of the present state.
  double plastic_work(double elastic_now) const;
  double numerical_dissipation() const;  ///< transfer loss over scale()
};

/// Energy stored in the stresses, J per metre of width.
double elastic_energy(const AnyModel& model, const LawTable& laws);

EnergyAudit begin_audit(const AnyModel& model, const LawTable& laws);

}  // namespace leda::solver
