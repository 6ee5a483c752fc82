#include "solver/run/softening_stage.hpp"

#include <algorithm>
#include <chrono>

#include "solver/kernel/instructions.hpp"
#include "solver/kernel/time_step.hpp"
#include "solver/run/checkpoint.hpp"
#include "solver/run/packed_surface.hpp"

namespace leda::solver {

namespace {

constexpr double rest_speed = 0.05;    // m/s
constexpr double rest_kinetic = 1e-4;  // of the peak
constexpr double rest_window_s = 1.0;
constexpr double most_energy_fed = 0.1;  // of the scale of the audit
constexpr std::int64_t looks_between_checks = 5;

using Wall = std::chrono::steady_clock;

// The window of rest starts anew whenever a particle is above the rest speed.
bool at_rest(RunState& run) {
  StageClock& clock = run.clock;
  const double kinetic = run.audit.kinetic;
  if (run.fastest > rest_speed || clock.still_since < 0) {
    clock.still_since = run.time;
    clock.still_kinetic = kinetic;
    return false;
  }
  if (run.time - clock.still_since < rest_window_s) return false;
  const bool calm = kinetic < rest_kinetic * run.audit.kinetic_peak;
  const bool fading = kinetic <= clock.still_kinetic;
  clock.still_since = run.time;
  clock.still_kinetic = kinetic;
  return calm || fading;
}

// Negative plastic work: the stress update has fed energy to the motion.
std::optional<StageEnd> check_plastic_work(const RunState& run) {
  const double elastic = elastic_energy(run.seeded.particles, run.seeded.laws);
  const double work = run.audit.plastic_work(elastic);
  if (work >= -most_energy_fed) return {};
  return StageEnd{StageEnd::Why::unstable,
                  "plastic work is negative (" + std::to_string(work * 100) +
                      " % of the energy that moved): the stress update feeds energy"};
}

}  // namespace

void show_frame(RunState& run) {
  if (!run.listener->frame) return;
  run.listener->frame(frame(run.seeded, run.seeded.laws, run.time));
  ++run.frames;
}

namespace {

void look(RunState& run) {
  const Surface now = run.packed ? packed_surface(run.packed->packs, run.packed->grid, run.seeded)
                                 : surface(run.seeded);
  run.slides.observe(run.time, retrogression(run.ground, now, run.bank));
  if (!run.listener->progress) return;
  const double share = run.time / run.settings->stop.max_time_s;
  const bool cut = run.clock.stage == StageClock::Stage::toe_cut;
  run.listener->progress({std::min(share, 1.0), run.time, cut ? "toe cut" : "softening"});
}

// What was checked last is what an unstable run falls back on.
std::optional<StageEnd> keep_good(RunState& run) {
  if (run.last_good.keep(run.seeded.particles, run.time)) return {};
  return StageEnd{StageEnd::Why::unstable, "a velocity or stress is beyond all measure"};
}

// Checkpoints by the wall clock; they only write the state down and cannot change the run.
class Checkpoints {
 public:
  bool is_due(const RunState& run) const {
    if (!run.listener->checkpoint) return false;
    const std::chrono::duration<double> since = Wall::now() - last_;
    return since.count() >= run.listener->checkpoint_interval_s;
  }

  void save(RunState& run) {
    if (!run.listener->checkpoint) return;
    const double before = run.run_time_before;
    run.run_time_before += std::chrono::duration<double>(Wall::now() - began_).count();
    const std::string state = save_state(run);
    run.run_time_before = before;
    run.listener->checkpoint(state, run.frames);
    last_ = Wall::now();
  }

 private:
  Wall::time_point began_ = Wall::now(), last_ = began_;
};

void begin(RunState& run, StageClock::Stage stage) {
  run.audit = begin_audit(run.seeded.particles, run.seeded.laws, run.seeded.grid.h);
  run.clock = StageClock{};
  run.clock.stage = stage;
  run.clock.next_look = run.time + run.slides.look_interval_s();
  run.clock.next_frame = run.time + run.settings->output.frame_interval_s;
  if (run.settings->precision == Precision::single_precision &&
      packs_can_run(run.seeded.grid, run.seeded.laws)) {
    run.packed = begin_packed_stage(run.seeded.particles, run.seeded.grid, run.seeded.laws,
                                    takes_long_steps(*run.settings));
    run.travel = 0;
  }
}

// The state of the packs, to where it is looked at.
void unpack_state(RunState& run) {
  if (run.packed) unpack(run.packed->packs, run.packed->grid, run.seeded.particles);
}

// A look at the surface, and every fifth time at all of the state.
std::optional<StageEnd> look_at(RunState& run, Checkpoints& checkpoints) {
  run.clock.next_look += run.slides.look_interval_s();
  const bool rests = at_rest(run);
  const bool checks = ++run.clock.looks % looks_between_checks == 0 || rests;
  const bool interrupted = run.listener->interrupted && run.listener->interrupted();
  const bool saves = interrupted || checkpoints.is_due(run);
  if (checks || saves) unpack_state(run);
  look(run);
  if (checks) {
    if (auto end = check_plastic_work(run)) return end;
    if (auto end = keep_good(run)) return end;
  }
  if (rests) return StageEnd{};
  if (saves) checkpoints.save(run);
  if (interrupted) return StageEnd{StageEnd::Why::interrupted, ""};
  return {};
}

std::optional<StageEnd> show_frame_if_due(RunState& run) {
  const double interval = run.settings->output.frame_interval_s;
  if (interval <= 0 || run.time < run.clock.next_frame) return {};
  unpack_state(run);
  if (auto end = keep_good(run)) return end;
  show_frame(run);
  run.clock.next_frame += interval;
  return {};
}

StageEnd run_steps(RunState& run) {
  if (auto end = keep_good(run)) return *end;
  Checkpoints checkpoints;
  while (run.time < run.settings->stop.max_time_s) {
    if (auto end = advance(run, run.seeded.laws, run.settings->damping.dynamic, true)) return *end;
    if (auto end = show_frame_if_due(run)) return *end;
    if (run.time < run.clock.next_look) continue;
    if (auto end = look_at(run, checkpoints)) return *end;
  }
  unpack_state(run);
  return {StageEnd::Why::time_limit, ""};
}

}  // namespace

Engine engine_of(const RunState& run) {
  const bool softer = run.packed && run.packed->laws.softer;
  return {.precision = run.packed ? Precision::single_precision : Precision::double_precision,
          .instructions = instructions(),
          .time_step_factor = std::min(run.settings->time_step_factor, most_factor(softer)),
          .averaged_dilation = run.seeded.grid.averages()};
}

StageEnd run_stage(RunState& run, StageClock::Stage stage) {
  if (!run.team) run.team = std::make_shared<Team>(1);
  if (run.clock.stage != stage) begin(run, stage);
  run.engine = engine_of(run);
  StageEnd end = run_steps(run);
  if (run.packed && run.packed->kept) run.packs_balance = transfer_balance(*run.packed);
  run.packed.reset();
  run.since_sort = 0;
  return end;
}

}  // namespace leda::solver
