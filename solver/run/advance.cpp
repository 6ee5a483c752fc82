#include <algorithm>
#include <cmath>

#include "solver/kernel/time_step.hpp"
#include "solver/run/run_state.hpp"

namespace leda::solver {

namespace {

constexpr double most_travel = 0.5;  // cells, before all points are put into their cells
constexpr double most_travel_a_step = 0.4;
constexpr double most_energy_gain = 0.1;
// Of h / c_p, with positions held. Light nodes at a free edge lower the limit there, and what is
// held cannot leave such an edge: a fin half a cell wide was unstable at 0.65 in 6000 steps.
constexpr double most_factor_held = 0.5;

// Ground faster than this slides: what only creeps or swings after a cut stays below it.
constexpr double sliding_speed = 0.5;  // m/s

constexpr const char* left_model = "a particle left the model";

template <class Real>
std::optional<StageEnd> keep_tidy(RunState& run, Model<Real>& model) {
  if (run.travel <= most_travel * run.seeded.size.h && !is_untidy(model)) return {};
  if (!tidy_up(model)) return StageEnd{StageEnd::Why::left_domain, left_model};
  run.travel = 0;
  return {};
}

// Failure begins at the strength of the laboratory's rate: what there fails slowly, over hours,
// would be held up in a run of minutes. With the slide comes its rate.
template <class Real>
void bring_in_rate(RunState& run, Model<Real>& model) {
  if (run.rate_since >= 0 || run.fastest < sliding_speed || !has_rate(run.seeded.laws)) return;
  run.rate_since = run.time;
  take_laws(model, run.seeded.laws);
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
  const double all = sums.points.momentum_x + sums.points.momentum_z + sums.points.stress_work +
                     sums.grid.kinetic_after;
  if (!std::isfinite(all)) {
    return StageEnd{StageEnd::Why::unstable, "a velocity or stress is not finite"};
  }
  if (run.fastest * dt > most_travel_a_step * run.seeded.size.h) {
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

template <class Real>
std::optional<StageEnd> advance(RunState& run, Model<Real>& model, double damping, bool move) {
  if (auto end = keep_tidy(run, model)) return end;
  const double asked = run.settings->time_step_factor;
  const double factor = move ? asked : std::min(asked, most_factor_held);
  const double dt =
      time_step(run.seeded.size.h, run.seeded.laws.stiffest_speed, run.fastest, factor);
  const StepSettings settings{dt, gravity, damping, move};
  const StepSums sums = step(model, settings, is_looked_at(run, dt), *run.team);
  run.audit.add(sums, settings);
  run.node_sums = sums.grid;
  run.fastest = std::sqrt(sums.points.fastest_squared);
  run.time += dt;
  if (move) {
    run.travel += run.fastest * dt;
    bring_in_rate(run, model);
  }
  ++run.steps;
  run.particle_steps += static_cast<double>(model.stepped);
  if (sums.points.left_grid) return StageEnd{StageEnd::Why::left_domain, left_model};
  return check(run, sums, dt, move);
}

}  // namespace

std::optional<StageEnd> advance(RunState& run, double damping, bool move) {
  return with_model(run.model, [&](auto& model) { return advance(run, model, damping, move); });
}

LawTable laws_now(const RunState& run) {
  return run.rate_since < 0 ? without_rate(run.seeded.laws) : run.seeded.laws;
}

ModelSettings moving_settings(const RunState& run) {
  return {.softer = takes_long_steps(*run.settings),
          .averages = run.seeded.averages,
          .keeps_force = false,
          .rests = run.settings->ground_rests};
}

bool take_particles(RunState& run, const Particles& particles) {
  return with_model(run.model, [&]<class Real>(Model<Real>& model) {
    auto made = make_model<Real>(particles, run.seeded.size, laws_now(run), model.settings);
    if (!made) return false;
    model = std::move(*made);
    return true;
  });
}

}  // namespace leda::solver
