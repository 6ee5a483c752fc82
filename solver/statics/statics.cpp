#include "solver/statics/statics.hpp"

#include <algorithm>
#include <cmath>

#include "solver/kernel/sort_particles.hpp"
#include "solver/kernel/transfer.hpp"
#include "solver/section/section.hpp"
#include "solver/statics/accelerator.hpp"
#include "solver/statics/stiffness.hpp"

namespace leda::solver {

namespace {

constexpr double aimed_ratio = 1e-6;     // unbalanced force over weight
constexpr double accepted_ratio = 1e-4;  // where the rounds run out: as good as the relaxation
constexpr int most_rounds = 80;
constexpr int remembered = 8;
constexpr double filling = 1e-6;  // of a full cell's stiffness, where few particles hold a node
constexpr double most_bytes = 1e9;
// One stress update takes the whole increment: its rotation is linearised, and a slide that has
// no balance shows by growing without end.
constexpr double most_gradient = 0.5;

// The arrays of a particle that a stress update changes and a new trial starts from.
struct StressState {
  std::vector<double> sxx, szz, sxz, syy, plastic_strain;

  explicit StressState(const Particles& p)
      : sxx(p.sxx), szz(p.szz), sxz(p.sxz), syy(p.syy), plastic_strain(p.plastic_strain) {}

  void restore(Particles& p) const {
    p.sxx = sxx;
    p.szz = szz;
    p.sxz = sxz;
    p.syy = syy;
    p.plastic_strain = plastic_strain;
  }
};

GridSums unbalanced(const Particles& particles, Grid& grid) {
  clear(grid);
  particles_to_grid(particles, grid);
  return update_velocity(grid, {0.0, gravity, 0.0});
}

double largest_gradient(const Particles& p) {
  double largest = 0;
  for (const auto* c : {&p.cxx, &p.cxz, &p.czx, &p.czz}) {
    for (std::size_t i = 0; i < p.count; ++i) largest = std::max(largest, std::abs((*c)[i]));
  }
  return largest;
}

}  // namespace

std::optional<Statics> Statics::prepare(Particles& particles, Grid& grid, const LawTable& laws) {
  if (!sort_particles(particles, grid)) return {};
  unbalanced(particles, grid);
  Freedoms freedoms = number_freedoms(grid);
  if (freedoms.count() == 0 || ColumnMatrix::bytes(freedoms) > most_bytes) return {};
  ColumnMatrix factor = elastic_stiffness(particles, laws, grid, freedoms, filling);
  if (!factor.factorize()) return {};
  return Statics(std::move(freedoms), std::move(factor));
}

StaticBalance Statics::balance(Particles& particles, Grid& grid, const LawTable& laws,
                               const std::function<bool()>& interrupted) const {
  using Vector = ColumnMatrix::Vector;
  using End = StaticBalance::End;
  StaticBalance result;
  const StressState start(particles);
  Accelerator accelerator(freedoms_.count(), remembered);
  unbalanced(particles, grid);  // averages of the grid belong to the positions
  Vector displacement = Vector::Zero(freedoms_.count()), force(freedoms_.count());
  for (; result.rounds < most_rounds; ++result.rounds) {
    if (interrupted && interrupted()) {
      result.end = End::interrupted;
      break;
    }
    start.restore(particles);
    set_displacement(freedoms_, displacement.data(), grid);
    // Displacement as a velocity over one second: the transfers of a step, nothing of its own.
    grid_to_particles(particles, grid, laws, 1.0, false);
    const GridSums sums = unbalanced(particles, grid);
    result.ratio = sums.weight > 0 ? sums.unbalanced_force / sums.weight : 0.0;
    if (!(largest_gradient(particles) < most_gradient) || !std::isfinite(result.ratio)) break;
    const bool last = result.rounds + 1 == most_rounds;
    if (result.ratio < aimed_ratio || (last && result.ratio < accepted_ratio)) {
      result.end = End::balanced;
      return result;
    }
    gather_force(freedoms_, grid, force.data());
    Vector correction = force;
    factor_.solve(correction);
    displacement = accelerator.next(displacement, correction, force);
  }
  start.restore(particles);
  return result;
}

}  // namespace leda::solver
