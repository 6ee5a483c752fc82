#pragma once
// Everything a run carries from step to step.

#include <memory>
#include <string>

#include "solver/run/audit.hpp"
#include "solver/run/last_good.hpp"
#include "solver/run/model_of_run.hpp"
#include "solver/run/observe.hpp"
#include "solver/run/seed_particles.hpp"
#include "solver/run/simulate.hpp"
#include "solver/section/run_settings.hpp"
#include "solver/section/section.hpp"

namespace leda::solver {

/// Where a moving stage stands.
struct StageClock {
  enum class Stage : std::int32_t { none, softening, toe_cut };
  Stage stage = Stage::none;
  double next_look = 0, next_frame = 0;  ///< s
  double still_since = -1;               ///< no particle faster than the rest speed since, s
  double still_kinetic = 0;              ///< kinetic energy then, J per metre
  std::int64_t looks = 0;
};

struct RunState {
  const Section* section = nullptr;
  const RunSettings* settings = nullptr;
  const Listener* listener = nullptr;

  Seeded seeded;  ///< without its particles, which are in the model
  AnyModel model;
  std::shared_ptr<ThreadTeam> team;  ///< of the process, no part of the state
  CrestAndToe bank;
  Surface ground;  ///< tops of the particle columns before anything moved
  SlideCount slides;
  EnergyAudit audit;  ///< of the stage under way
  Balances worst;
  double numerical_dissipation = 0;

  double time = 0;         ///< since softening is on, s
  double rate_since = -1;  ///< strength depends on the rate since this time, s; below 0: not yet
  double fastest = 0;      ///< speed of the fastest particle, m/s
  std::int64_t steps = 0;
  double particle_steps = 0;
  GridSums node_sums;  ///< of the last step
  double travel = 0;  ///< the most a particle may have moved since all were put into their cells, m
  StageClock clock;
  Engine engine;               ///< of the moving stage, no part of the state
  LastGood last_good;          ///< what the run ends with should it become unstable
  bool resumed = false;        ///< the state comes from a checkpoint
  std::int64_t frames = 0;     ///< handed to the listener so far
  double run_time_before = 0;  ///< of the processes before this one, s
  std::vector<std::string> warnings;
};

/// Why a stage ended.
struct StageEnd {
  enum class Why { at_rest, time_limit, left_domain, unstable, interrupted };
  Why why = Why::at_rest;
  std::string reason;  ///< of left_domain and unstable
};

/// The laws that hold now: until ground slides, strength is that of the laboratory's rate.
LawTable laws_now(const RunState& run);

/// How the model of a moving stage is run.
ModelSettings moving_settings(const RunState& run);

/// A model of these particles, of the same precision as before.
/// @return false where a particle lies outside the grid; nothing is changed then
bool take_particles(RunState& run, const Particles& particles);

/// What computes the stage under way; before the first, the quiet ones.
Engine engine_of(const RunState& run);

/// One step with the time step the present state allows, and the checks that go with it.
/// @return nothing while the run is sound
std::optional<StageEnd> advance(RunState& run, double damping, bool move);

}  // namespace leda::solver
