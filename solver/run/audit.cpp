#include "solver/run/audit.hpp"

#include <algorithm>
#include <cmath>

#include "solver/section/section.hpp"

namespace leda::solver {

double elastic_energy(const AnyModel& model, const LawTable& laws) {
  double energy = 0;
  with_model(model, [&](const auto& m) {
    for_each_point(m.packs, [&](std::size_t i, std::size_t l) {
      const auto& p = m.packs.pack[i];
      const auto row = static_cast<std::size_t>(p.law[l]);
      const double sxx = p.sxx[l], szz = p.szz[l], syy = p.syy[l], sxz = p.sxz[l];
      const double mean = (sxx + szz + syy) / 3;
      const double x = sxx - mean, y = syy - mean, z = szz - mean;
      const double deviator = x * x + y * y + z * z + 2 * sxz * sxz;
      energy += static_cast<double>(p.volume[l]) *
                (deviator / (4 * laws.shear[row]) + mean * mean / (2 * laws.bulk[row]));
    });
  });
  return energy;
}

EnergyAudit begin_audit(const AnyModel& model, const LawTable& laws) {
  EnergyAudit audit;
  with_model(model, [&](const auto& m) {
    double mass = 0;
    for_each_point(m.packs, [&](std::size_t i, std::size_t l) {
      mass += static_cast<double>(m.packs.pack[i].mass[l]);
    });
    audit.least_scale = mass * gravity * 1e-3 * m.grid.h;
  });
  audit.elastic_start = elastic_energy(model, laws);
  return audit;
}

void EnergyAudit::add(const StepSums& sums, const StepSettings& step) {
  if (!started) {
    kinetic_start = sums.grid.kinetic_before;
    started = true;
  } else {
    transfer_loss += kinetic - sums.grid.kinetic_before;
  }
  kinetic = sums.grid.kinetic_after;
  kinetic_peak = std::max(kinetic_peak, kinetic);
  gravity_work -= step.gravity * sums.points.momentum_z * step.dt;
  damping_work += sums.grid.damping_work;
  stress_work += sums.points.stress_work;
}

double EnergyAudit::scale() const {
  return std::max({std::abs(gravity_work), std::abs(stress_work), kinetic_peak, least_scale});
}

double EnergyAudit::residual() const {
  const double rest =
      kinetic - kinetic_start - gravity_work - damping_work + stress_work + transfer_loss;
  return scale() > 0 ? rest / scale() : 0.0;
}

double EnergyAudit::plastic_work(double elastic_now) const {
  return scale() > 0 ? (stress_work - (elastic_now - elastic_start)) / scale() : 0.0;
}

double EnergyAudit::numerical_dissipation() const {
  return scale() > 0 ? transfer_loss / scale() : 0.0;
}

}  // namespace leda::solver
