#include "solver/run/softening_stage.hpp"

#include <algorithm>
#include <chrono>

#include "solver/kernel/time_step.hpp"
#include "solver/run/checkpoint.hpp"
#include "solver/run/initial_stress.hpp"

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

// At rest there is no rate. Ground that only a rate law brought to rest, before anything to be seen
// has moved, fails at the laboratory's strength and has not done so yet: it has that strength
// again.
bool goes_on_without_rate(RunState& run) {
  if (run.rate_since < 0) return false;
  if (measure(run.model, run.seeded, *run.section, run.bank, run.ground).moved()) return false;
  run.rate_since = -1;
  run.clock.still_since = -1;
  with_model(run.model, [&](auto& model) {
    take_laws(model, laws_now(run));
    wake(model);
  });
  return true;
}

// Negative plastic work: the stress update has fed energy to the motion.
std::optional<StageEnd> check_plastic_work(const RunState& run) {
  const double elastic = elastic_energy(run.model, run.seeded.laws);
  const double work = run.audit.plastic_work(elastic);
  if (work >= -most_energy_fed) return {};
  return StageEnd{StageEnd::Why::unstable,
                  "plastic work is negative (" + std::to_string(work * 100) +
                      " % of the energy that moved): the stress update feeds energy"};
}

}  // namespace

void show_frame(RunState& run) {
  if (!run.listener->frame) return;
  run.listener->frame(frame(run.model, run.seeded, run.time));
  ++run.frames;
}

namespace {

void look(RunState& run) {
  const Surface now = surface(run.model, run.seeded);
  run.slides.observe(run.time, retrogression(run.ground, now, run.bank));
  if (!run.listener->progress) return;
  const double share = run.time / run.settings->stop.max_time_s;
  const bool cut = run.clock.stage == StageClock::Stage::toe_cut;
  run.listener->progress({std::min(share, 1.0), run.time, cut ? "toe cut" : "softening"});
}

// What was checked last is what an unstable run falls back on.
std::optional<StageEnd> keep_good(RunState& run) {
  if (run.last_good.keep(run.model, run.time)) return {};
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
  begin_moving(run);
  run.audit = begin_audit(run.model, run.seeded.laws);
  run.clock = StageClock{};
  run.clock.stage = stage;
  run.clock.next_look = run.time + run.slides.look_interval_s();
  run.clock.next_frame = run.time + run.settings->output.frame_interval_s;
  run.travel = 0;
}

// A look at the surface, and every fifth time at all of the state.
std::optional<StageEnd> look_at(RunState& run, Checkpoints& checkpoints) {
  run.clock.next_look += run.slides.look_interval_s();
  const bool rests = at_rest(run) && !goes_on_without_rate(run);
  const bool checks = ++run.clock.looks % looks_between_checks == 0 || rests;
  const bool interrupted = run.listener->interrupted && run.listener->interrupted();
  const bool saves = interrupted || checkpoints.is_due(run);
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
  if (auto end = keep_good(run)) return end;
  show_frame(run);
  run.clock.next_frame += interval;
  return {};
}

StageEnd run_steps(RunState& run) {
  if (auto end = keep_good(run)) return *end;
  Checkpoints checkpoints;
  while (run.time < run.settings->stop.max_time_s) {
    if (auto end = advance(run, run.settings->damping.dynamic, true)) return *end;
    if (auto end = show_frame_if_due(run)) return *end;
    if (run.time < run.clock.next_look) continue;
    if (auto end = look_at(run, checkpoints)) return *end;
  }
  return {StageEnd::Why::time_limit, ""};
}

}  // namespace

StageEnd run_stage(RunState& run, StageClock::Stage stage) {
  if (!run.team) run.team = std::make_shared<ThreadTeam>(1);
  if (run.clock.stage != stage) begin(run, stage);
  run.engine = engine_of(run);
  return run_steps(run);
}

}  // namespace leda::solver
