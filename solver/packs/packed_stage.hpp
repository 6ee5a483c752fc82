#pragma once
// A moving stage on packs: what it holds, and its steps.

#include <optional>

#include "solver/packs/arrange.hpp"
#include "solver/packs/pack_step.hpp"
#include "solver/packs/team.hpp"
#include "solver/section/section_result.hpp"
#include "solver/step.hpp"

namespace leda::solver {

struct PackedStage {
  Packs packs;
  PackGrid grid;
  PackLaws laws;
  std::size_t strayed = 0;  ///< points outside the cell they were arranged into, step by step
  bool kept = false;        ///< the last step kept the motion
};

/// Whether packs can run these laws on this grid: no rate, no flow, nothing averaged.
bool packs_can_run(const Grid& grid, const LawTable& laws);

/// Packs of the particles, their sums on the grid. Left empty where a particle is off the grid.
std::optional<PackedStage> begin_packed_stage(const Particles& particles, const Grid& grid,
                                              const LawTable& laws);

/// Adds all points to the sums, in the order in which a step does.
/// @pre packs.motion holds their motion
void spread_all(PackedStage& stage);

/// step() of a moving stage, on packs. `keep`: the motion can be read afterwards.
/// @pre no point has moved by more than a cell since the packs were arranged
StepSums step(PackedStage& stage, const StepSettings& settings, bool keep, Team& team,
              bool& left_grid);

/// Whether so many points have strayed that arranging them anew is the cheaper way on.
bool is_untidy(const PackedStage& stage);

/// Relative difference of mass and momentum between points and nodes.
/// @pre the last step kept the motion
Balances transfer_balance(const PackedStage& stage);

}  // namespace leda::solver
