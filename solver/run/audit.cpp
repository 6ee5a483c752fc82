#include "solver/run/audit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "solver/section/section.hpp"

namespace leda::solver {

double elastic_energy(const Particles& p, const LawTable& laws) {
  double energy = 0;
  for (std::size_t i = 0; i < p.count; ++i) {
    const auto row = static_cast<std::size_t>(p.law[i]);
    const double mean = (p.sxx[i] + p.szz[i] + p.syy[i]) / 3;
    const double x = p.sxx[i] - mean, y = p.syy[i] - mean, z = p.szz[i] - mean;
    const double deviator = x * x + y * y + z * z + 2 * p.sxz[i] * p.sxz[i];
    energy += p.volume[i] * (deviator / (4 * laws.shear[row]) + mean * mean / (2 * laws.bulk[row]));
  }
  return energy;
}

EnergyAudit begin_audit(const Particles& particles, const LawTable& laws, double h) {
  EnergyAudit audit;
  const double mass = std::accumulate(particles.mass.begin(), particles.mass.end(), 0.0);
  audit.least_scale = mass * gravity * 1e-3 * h;
  audit.elastic_start = elastic_energy(particles, laws);
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
  gravity_work -= step.gravity * sums.particles.momentum_z * step.dt;
  damping_work += sums.grid.damping_work;
  stress_work += sums.particles.stress_work;
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

Balances transfer_balance(const Particles& particles, Grid& grid) {
  clear(grid);
  particles_to_grid(particles, grid);
  double node_mass = 0, node_x = 0, node_z = 0;
  for (std::size_t i = 0; i < grid.columns; ++i) {
    const double* node = grid.at(i, 0);
    for (std::size_t k = 0; k < grid.top[i]; ++k, node += Grid::width) {
      node_mass += node[0];
      node_x += node[1];
      node_z += node[2];
    }
  }
  double mass = 0, x = 0, z = 0, size = 0;
  for (std::size_t i = 0; i < particles.count; ++i) {
    mass += particles.mass[i];
    x += particles.mass[i] * particles.vx[i];
    z += particles.mass[i] * particles.vz[i];
    size += particles.mass[i] * std::hypot(particles.vx[i], particles.vz[i]);
  }
  Balances balances;
  balances.mass = mass > 0 ? std::abs(node_mass - mass) / mass : 0.0;
  balances.momentum = size > 0 ? std::hypot(node_x - x, node_z - z) / size : 0.0;
  return balances;
}

}  // namespace leda::solver
