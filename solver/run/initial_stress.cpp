#include "solver/run/initial_stress.hpp"

#include <algorithm>
#include <cmath>

#include "solver/statics/statics.hpp"

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

// A balance by static solves. Left unreached where there is none, or none the statics can find.
std::optional<StageEnd> solve(RunState& run, const Statics& statics, const LawTable& laws,
                              const char* stage, Balance& balance) {
  if (run.listener->progress) run.listener->progress({0.0, 0.0, stage});
  const StaticBalance found =
      statics.balance(run.seeded.particles, run.seeded.grid, laws, run.listener->interrupted);
  zero_motion(run.seeded.particles);
  if (found.end == StaticBalance::End::interrupted) {
    return StageEnd{StageEnd::Why::interrupted, ""};
  }
  balance = {found.end == StaticBalance::End::balanced, found.ratio};
  return {};
}

std::optional<StageEnd> settle(RunState& run, const std::optional<Statics>& statics, bool elastic,
                               Balance& balance) {
  const LawTable laws = without_softening(run.seeded.laws, elastic);
  const char* stage = elastic ? "initial stress" : "undrained";
  balance = {};
  if (statics) {
    if (auto end = solve(run, *statics, laws, stage, balance)) return end;
  }
  if (!balance.reached) {
    const int most = elastic ? most_elastic_steps : most_plastic_steps;
    if (auto end = relax(run, laws, most, stage, balance)) return end;
  }
  zero_motion(run.seeded.particles);
  return {};
}

}  // namespace

std::optional<StageEnd> find_initial_stress(RunState& run, QuietMethod method) {
  Balance balance;
  std::optional<Statics> statics;
  if (method == QuietMethod::direct) {
    statics = Statics::prepare(run.seeded.particles, run.seeded.grid, run.seeded.laws);
  }
  if (auto end = settle(run, statics, true, balance)) return end;
  if (auto end = settle(run, statics, false, balance)) return end;
  if (!balance.reached) {
    run.warnings.push_back("no equilibrium at the undrained peak strength (unbalanced force " +
                           std::to_string(balance.ratio * 100) +
                           " % of the weight): the section slides without softening");
  }
  run.fastest = 0;
  run.time = 0;
  return {};
}

}  // namespace leda::solver
