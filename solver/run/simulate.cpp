#include "solver/run/simulate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "solver/run/checkpoint.hpp"
#include "solver/run/initial_stress.hpp"
#include "solver/run/softening_stage.hpp"
#include "solver/run/trigger.hpp"
#include "solver/section/fault_list.hpp"
#include "solver/section/warnings.hpp"

namespace leda::solver {

namespace {

CrestAndToe bank_of(const Section& section) {
  CrestAndToe bank;
  if (const auto found = find_crest_and_toe(section.ground))
    bank = *found;
  else
    bank = {section.ground.front(), section.ground.back()};
  if (section.crest) bank.crest = *section.crest;
  if (section.toe) bank.toe = *section.toe;
  return bank;
}

// An audit that is itself not finite counts as all of the energy.
double share(double audited) { return std::isfinite(audited) ? audited : 1.0; }

void keep_worst(RunState& run) {
  run.worst.energy = std::max(run.worst.energy, std::abs(share(run.audit.residual())));
  run.numerical_dissipation =
      std::max(run.numerical_dissipation, share(run.audit.numerical_dissipation()));
}

// Softening on; where the section stands and a cut is asked for, the cut.
StageEnd trigger_and_run(RunState& run, std::string& used) {
  using Stage = StageClock::Stage;
  const auto* excavation = std::get_if<ExcavationTrigger>(&run.settings->trigger);
  const auto* undrained = std::get_if<UndrainedTrigger>(&run.settings->trigger);
  if (run.clock.stage != Stage::toe_cut) {
    used = excavation ? "excavation" : "undrained";
    if (excavation && !run.resumed) excavate(run, excavation->polygon);
    StageEnd end = run_stage(run, Stage::softening);
    keep_worst(run);
    const bool stands = end.why == StageEnd::Why::at_rest &&
                        !measure(run.model, run.seeded, *run.section, run.bank, run.ground).moved();
    if (!stands || !undrained || !undrained->then_toe_cut_m) return end;
    excavate(run, toe_cut(*run.section, run.bank, *undrained->then_toe_cut_m));
  }
  used = "toe-cut";
  StageEnd end = run_stage(run, Stage::toe_cut);
  keep_worst(run);
  return end;
}

RunStatus status_of(const StageEnd& end, bool has_moved) {
  switch (end.why) {
    case StageEnd::Why::at_rest:
      return has_moved ? RunStatus::at_rest : RunStatus::stable;
    case StageEnd::Why::time_limit:
      return RunStatus::time_limit;
    case StageEnd::Why::left_domain:
      return RunStatus::left_domain;
    case StageEnd::Why::unstable:
      return RunStatus::unstable;
    case StageEnd::Why::interrupted:
      return RunStatus::interrupted;
  }
  return RunStatus::unstable;
}

Polyline profile_after(const RunState& run) {
  const Surface now = surface(run.model, run.seeded);
  Polyline line;
  for (std::size_t i = 0; i < now.z.size(); ++i) line.push_back({now.middle(i), now.z[i]});
  return line;
}

std::string rounded(double value) { return show(std::round(value * 100) / 100); }

// A run that ended before the ground did.
void warn_of_end(const RunState& run, const StageEnd& end, std::vector<std::string>& warnings) {
  const std::string consequence = ": retrogression and runout are lower bounds";
  if (end.why == StageEnd::Why::time_limit) {
    warnings.push_back("stopped at the time limit of " + show(run.settings->stop.max_time_s) +
                       " s while moving at " + rounded(run.fastest) + " m/s" + consequence);
  } else if (end.why == StageEnd::Why::left_domain) {
    warnings.push_back("stopped as ground left the model" + consequence);
  }
}

void warn(const RunState& run, const Movement& m, std::vector<std::string>& warnings) {
  const double near = 2 * run.seeded.size.h;
  const double left = run.section->ground.front().x, right = run.section->ground.back().x;
  const auto at_edge = [&](double x) { return x - left < near || right - x < near; };
  if ((m.retrogression_m > 0 || m.runout_m > 0) && at_edge(m.backscarp.x)) {
    warnings.emplace_back("the backscarp reached the model's edge: retrogression is a lower bound");
  }
  if (m.runout_m > 0 && at_edge(m.front.x)) {
    warnings.emplace_back("the front reached the model's edge: runout is a lower bound");
  }
  if (m.far_side_dropped) {
    warnings.emplace_back(
        "ground beyond the toe slid too: lay a section of its own for the far bank");
  }
}

void keep_balance(RunState& run) {
  const Balances balance =
      with_model(run.model, [](auto& model) { return transfer_balance(model); });
  run.worst.mass = balance.mass;
  run.worst.momentum = balance.momentum;
}

// What broke a run is no result: the state before it is, and the reason tells both times.
void fall_back(RunState& run, StageEnd& end, bool moving) {
  const double broke = run.time;
  Particles particles = run.last_good.empty()
                            ? seed_particles(*run.section, run.settings->resolution).particles
                            : particles_of(run.model);
  run.time = run.last_good.restore(particles);
  take_particles(run, particles);
  end.reason += moving ? " at " + std::to_string(broke) + " s" : " while the initial stress formed";
  end.reason += "; what is shown is the sound state at " + std::to_string(run.time) + " s";
}

SectionResult result_of(RunState& run, const StageEnd& end) {
  const Movement m = measure(run.model, run.seeded, *run.section, run.bank, run.ground);
  SectionResult r;
  r.status = status_of(end, m.moved());
  r.reason = end.reason;
  r.crest = run.bank.crest;
  r.toe = run.bank.toe;
  r.crest_to_crest_retrogression_m = m.retrogression_m;
  r.runout_m = m.runout_m;
  r.runout_from_crest_m = m.runout_m > 0 ? std::abs(m.front.x - run.bank.crest.x) : 0.0;
  r.backscarp = m.backscarp;
  r.front = m.front;
  r.slides = run.slides.count();
  if (run.rate_since >= 0) r.rate_from_s = run.rate_since;
  r.simulated_s = run.time;
  r.steps = run.steps;
  r.particles = with_model(
      run.model, [](const auto& model) { return static_cast<std::int64_t>(model.packs.count); });
  r.balances = run.worst;
  r.numerical_dissipation = run.numerical_dissipation;
  r.profile_after = profile_after(run);
  r.engine = run.engine;
  // First what bounds the numbers: where texts are cut, the last are lost.
  warn_of_end(run, end, r.warnings);
  warn(run, m, r.warnings);
  r.warnings.insert(r.warnings.end(), run.warnings.begin(), run.warnings.end());
  add_new(r.warnings, warnings_of(*run.section, *run.settings));
  for (const SampledField& field : run.seeded.fields) r.warnings.push_back(field.told());
  mark_lower_bounds(r);
  return r;
}

RunState start(const Section& section, const RunSettings& settings, const Listener& listener) {
  RunState run;
  run.section = &section;
  run.settings = &settings;
  run.listener = &listener;
  run.seeded = seed_particles(section, settings.resolution);
  run.bank = bank_of(section);
  begin_quiet(run);
  run.ground = surface(run.model, run.seeded);
  run.slides = SlideCount(run.bank.crest.z - run.bank.toe.z, settings.resolution.cell_m);
  run.engine = engine_of(run);
  return run;
}

}  // namespace

SectionResult simulate(const Section& section, const RunSettings& settings,
                       const Listener& listener, int threads) {
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  RunState run = start(section, settings, listener);
  run.team = std::make_shared<ThreadTeam>(threads);
  std::string used = "none";
  StageEnd end;
  if (!listener.resume_from.empty()) load_state(listener.resume_from, run);
  if (!listener.resume_from.empty() && listener.resumed) listener.resumed(run.resumed);
  std::optional<StageEnd> early;
  if (!run.resumed) early = find_initial_stress(run);
  if (!run.resumed && !early) show_frame(run);
  end = early ? *early : trigger_and_run(run, used);
  if (end.why == StageEnd::Why::unstable || end.why == StageEnd::Why::left_domain) {
    fall_back(run, end, !early);
  }
  keep_balance(run);
  SectionResult result = result_of(run, end);
  result.trigger_used = used;
  show_frame(run);
  result.run_time_s =
      run.run_time_before + std::chrono::duration<double>(Clock::now() - began).count();
  if (run.particle_steps > 0)
    result.ns_per_particle_step = result.run_time_s * 1e9 / run.particle_steps;
  return result;
}

}  // namespace leda::solver
