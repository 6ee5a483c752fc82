#include <algorithm>
#include <cmath>

#include "solver/kernel/sort_particles.hpp"
#include "solver/kernel/time_step.hpp"
#include "solver/run/run_state.hpp"

namespace leda::solver {

namespace {

constexpr int most_steps_between_sorts = 32;
constexpr double most_travel = 0.5;  // cells, before the order of the particles is renewed
constexpr double most_travel_a_step = 0.4;
constexpr double most_energy_gain = 0.1;
// Of h / c_p, with positions held. Light nodes at a free edge lower the limit there, and what is
// held cannot leave such an edge: a fin half a cell wide was unstable at 0.65 in 6000 steps.
constexpr double most_factor_held = 0.5;

constexpr const char* left_model = "a particle left the model";

std::optional<StageEnd> keep_sorted(RunState& run, PackedStage& stage) {
  if (run.travel <= most_travel * run.seeded.grid.h && !is_untidy(stage)) return {};
  if (!tidy_up(stage)) return StageEnd{StageEnd::Why::left_domain, left_model};
  run.travel = 0;
  return {};
}

std::optional<StageEnd> keep_sorted(RunState& run) {
  if (run.packed) return keep_sorted(run, *run.packed);
  const bool due = run.since_sort == 0 || run.since_sort >= most_steps_between_sorts ||
                   run.travel > most_travel * run.seeded.grid.h;
  if (due) {
    if (!sort_particles(run.seeded.particles, run.seeded.grid)) {
      return StageEnd{StageEnd::Why::left_domain, left_model};
    }
    run.since_sort = 0;
    run.travel = 0;
  }
  ++run.since_sort;
  return {};
}

// Whether the state after a step of dt is one that somebody looks at.
bool is_looked_at(const RunState& run, double dt) {
  const double then = run.time + dt;
  const bool frames = run.settings->output.frame_interval_s > 0;
  return then >= run.clock.next_look || (frames && then >= run.clock.next_frame) ||
         then >= run.settings->stop.max_time_s;
}

// Positions that are held do no work the audit could follow: it looks at moving ground only.
std::optional<StageEnd> check(const RunState& run, const StepSums& sums, double dt, bool move) {
  const double all = sums.particles.momentum_x + sums.particles.momentum_z +
                     sums.particles.stress_work + sums.grid.kinetic_after;
  if (!std::isfinite(all)) {
    return StageEnd{StageEnd::Why::unstable, "a velocity or stress is not finite"};
  }
  if (run.fastest * dt > most_travel_a_step * run.seeded.grid.h) {
    return StageEnd{StageEnd::Why::unstable, "a particle moves at " + std::to_string(run.fastest) +
                                                 " m/s, further than 0.4 cells a step"};
  }
  if (move && run.audit.residual() > most_energy_gain) {
    return StageEnd{StageEnd::Why::unstable, "the energy audit finds " +
                                                 std::to_string(run.audit.residual() * 100) +
                                                 " % of energy out of nothing (10 % is the most)"};
  }
  return {};
}

}  // namespace

std::optional<StageEnd> advance(RunState& run, const LawTable& laws, double damping, bool move) {
  if (auto end = keep_sorted(run)) return end;
  const double asked = run.settings->time_step_factor;
  const double factor = move ? run.engine.time_step_factor : std::min(asked, most_factor_held);
  const double dt = time_step(run.seeded.grid.h, laws.stiffest_speed, run.fastest, factor);
  const StepSettings settings{dt, gravity, damping, move, run.settings->ground_rests};
  bool left_grid = false;
  const StepSums sums =
      run.packed ? step(*run.packed, settings, is_looked_at(run, dt), *run.team, left_grid)
                 : step(run.seeded.particles, run.seeded.grid, laws, settings);
  run.audit.add(sums, settings);
  run.fastest = std::sqrt(sums.particles.fastest_squared);
  run.travel += run.fastest * dt;
  run.time += dt;
  ++run.steps;
  run.particle_steps +=
      static_cast<double>(run.packed ? run.packed->stepped : run.seeded.particles.count);
  if (left_grid) return StageEnd{StageEnd::Why::left_domain, left_model};
  return check(run, sums, dt, move);
}

}  // namespace leda::solver
