#pragma once
// A moving stage on packs: what it holds, and its steps.

#include <optional>

#include "solver/kernel/pack.hpp"
#include "solver/kernel/pack_step.hpp"
#include "solver/kernel/rest.hpp"
#include "solver/kernel/step.hpp"
#include "solver/kernel/team.hpp"
#include "solver/section/section_result.hpp"

namespace leda::solver {

struct PackedStage {
  Packs packs;
  PackGrid grid;
  PackLaws laws;
  std::size_t strayed = 0;      ///< points outside their home cell, summed over the steps
  bool kept = false;            ///< the last step kept the motion
  std::vector<GroupRest> rest;  ///< of the groups of columns
  std::int64_t steps = 0;
  std::size_t stepped = 0;  ///< points that the last step moved
  bool wakes = false;       ///< ground at rest has to be woken
};

/// Whether packs can run these laws on this grid: no rate, no flow, nothing averaged.
bool packs_can_run(const Grid& grid, const LawTable& laws);

/// A stage without points; `softer` as in PackLaws.
PackedStage empty_packed_stage(const Grid& grid, const LawTable& laws, bool softer);

/// Packs of the particles, their sums on the grid; `softer` as in PackLaws. Left empty where a
/// particle is off the grid.
std::optional<PackedStage> begin_packed_stage(const Particles& particles, const Grid& grid,
                                              const LawTable& laws, bool softer = false);

/// Adds all points to the sums, in the order in which a step does; of ground at rest those that
/// moving ground feels.
/// @pre packs.motion holds their motion
void spread_all(PackedStage& stage);

/// step() of a moving stage, on packs. `keep`: the motion can be read afterwards. Every 32nd step
/// keeps it too, and lays to rest the ground that has come to rest.
/// @pre no point has moved by more than a cell since it was put into its cell
StepSums step(PackedStage& stage, const StepSettings& settings, bool keep, Team& team,
              bool& left_grid);

/// Puts every point into the cell it has moved to. The motion is not kept.
/// @return false where a point has left the grid; nothing is changed then
bool tidy_up(PackedStage& stage);

/// Whether so many points have strayed that tidying up is the cheaper way on.
bool is_untidy(const PackedStage& stage);

/// Relative difference of mass and momentum between points and nodes. Wakes all ground.
/// @pre the last step kept the motion
Balances transfer_balance(PackedStage& stage);

}  // namespace leda::solver
