#include "solver/softening_stage.hpp"

#include <algorithm>
#include <cmath>

namespace leda::solver {

namespace {

constexpr double rest_speed = 0.05;    // m/s
constexpr double rest_kinetic = 1e-4;  // of the peak
constexpr double rest_window_s = 1.0;
constexpr double look_interval_s = 0.1;

// Watches for rest: the window starts anew with every particle above the rest speed.
class RestWatch {
 public:
  bool at_rest(double time, double fastest, const EnergyAudit& audit) {
    if (fastest > rest_speed || since_ < 0) {
      since_ = time;
      kinetic_ = audit.kinetic;
      return false;
    }
    if (time - since_ < rest_window_s) return false;
    const bool calm = audit.kinetic < rest_kinetic * audit.kinetic_peak;
    const bool fading = audit.kinetic <= kinetic_;
    since_ = time;
    kinetic_ = audit.kinetic;
    return calm || fading;
  }

 private:
  double since_ = -1;
  double kinetic_ = 0;
};

void report(RunState& run, const char* stage) {
  if (!run.listener->progress) return;
  const double share = run.time / run.settings->stop.max_time_s;
  run.listener->progress({std::min(share, 1.0), run.time, stage});
}

constexpr double most_energy_fed = 0.1;  // of the scale of the audit

// Negative plastic work: the stress update has fed energy to the motion.
std::optional<StageEnd> check_plastic_work(const RunState& run) {
  const double elastic = elastic_energy(run.seeded.particles, run.seeded.laws);
  const double work = run.audit.plastic_work(elastic);
  if (work >= -most_energy_fed) return {};
  return StageEnd{StageEnd::Why::unstable,
                  "plastic work is negative (" + std::to_string(work * 100) +
                      " % of the energy that moved): the stress update feeds energy"};
}

void look(RunState& run, const char* stage) {
  const Movement m = measure(run.seeded, *run.section, run.bank, run.ground);
  run.slides.observe(run.time, m.retrogression_m);
  report(run, stage);
}

}  // namespace

StageEnd run_softening(RunState& run, const char* stage) {
  RestWatch rest;
  run.audit = begin_audit(run.seeded.particles, run.seeded.laws, run.seeded.grid.h);
  double next_look = run.time + look_interval_s;
  const double frames = run.settings->output.frame_interval_s;
  double next_frame = run.time + frames;
  while (run.time < run.settings->stop.max_time_s) {
    if (auto end = advance(run, run.seeded.laws, run.settings->damping.dynamic, true)) return *end;
    if (frames > 0 && run.listener->frame && run.time >= next_frame) {
      run.listener->frame(frame(run.seeded, run.seeded.laws, run.time));
      next_frame += frames;
    }
    if (run.time < next_look) continue;
    next_look += look_interval_s;
    look(run, stage);
    if (auto end = check_plastic_work(run)) return *end;
    if (rest.at_rest(run.time, run.fastest, run.audit)) return {};
    if (run.listener->interrupted && run.listener->interrupted()) {
      return {StageEnd::Why::interrupted, ""};
    }
  }
  return {StageEnd::Why::time_limit, ""};
}

}  // namespace leda::solver
