#include "solver/initial_stress.hpp"

#include <algorithm>
#include <cmath>

namespace leda::solver {

namespace {

constexpr double balanced = 1e-4;  // unbalanced force over weight
constexpr int most_elastic_steps = 6000;
constexpr int most_plastic_steps = 6000;
constexpr int steps_between_looks = 25;

struct Balance {
  bool reached = false;
  double ratio = 1;
};

// Force on the nodes that is not balanced, over their weight, without taking a step in time.
double unbalanced_ratio(RunState& run) {
  Grid& grid = run.seeded.grid;
  clear(grid);
  particles_to_grid(run.seeded.particles, grid);
  const GridSums sums = update_velocity(grid, {0.0, gravity, 0.0});
  return sums.weight > 0 ? sums.unbalanced_force / sums.weight : 0.0;
}

std::optional<StageEnd> relax(RunState& run, const LawTable& laws, int most_steps,
                              const char* stage, Balance& balance) {
  run.audit = begin_audit(run.seeded.particles, run.seeded.laws, run.seeded.grid.h);
  for (int i = 1; i <= most_steps; ++i) {
    if (auto end = advance(run, laws, run.settings->damping.initial, false)) return end;
    if (i % steps_between_looks != 0) continue;
    balance.ratio = unbalanced_ratio(run);
    if (balance.ratio < balanced) {
      balance.reached = true;
      return {};
    }
    if (run.listener->interrupted && run.listener->interrupted()) {
      return StageEnd{StageEnd::Why::interrupted, ""};
    }
    if (run.listener->progress && i % (8 * steps_between_looks) == 0) {
      run.listener->progress({0.0, 0.0, stage});
    }
  }
  return {};
}

void zero_motion(Particles& p) {
  for (auto* array : {&p.vx, &p.vz, &p.cxx, &p.cxz, &p.czx, &p.czz, &p.plastic_strain}) {
    std::fill(array->begin(), array->end(), 0.0);
  }
}

}  // namespace

std::optional<StageEnd> find_initial_stress(RunState& run) {
  Balance balance;
  const LawTable elastic = without_softening(run.seeded.laws, true);
  if (auto end = relax(run, elastic, most_elastic_steps, "initial stress", balance)) return end;
  zero_motion(run.seeded.particles);
  const LawTable plastic = without_softening(run.seeded.laws, false);
  balance = {};
  if (auto end = relax(run, plastic, most_plastic_steps, "undrained", balance)) return end;
  if (!balance.reached) {
    run.warnings.push_back("no equilibrium at the undrained peak strength (unbalanced force " +
                           std::to_string(balance.ratio * 100) +
                           " % of the weight): the section slides without softening");
  }
  zero_motion(run.seeded.particles);
  run.fastest = 0;
  run.time = 0;
  return {};
}

}  // namespace leda::solver
