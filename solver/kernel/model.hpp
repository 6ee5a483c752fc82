#pragma once
// The numerical model of a section while it moves, or while its stress settles: points, grid, laws,
// and one explicit step of the material point method.

#include <optional>

#include "solver/kernel/kernel.hpp"
#include "solver/kernel/rest.hpp"
#include "solver/kernel/thread_team.hpp"
#include "solver/section/section_result.hpp"

namespace leda::solver {

/// How a model is run.
struct ModelSettings {
  bool softer = false;    ///< as in Laws: steps longer than ground as it is can take
  bool averages = false;  ///< dilation is averaged over spans (B-bar): nearly incompressible ground
  bool keeps_force = false;  ///< grid.force and its sums are kept
  bool rests = true;         ///< ground at rest is not stepped
  bool held = false;         ///< points stay where they are: no reserve, and no motion that is kept
};

template <class Real>
struct Model {
  const Kernel<Real>* kernel = &solver::kernel<Real>();
  ModelSettings settings;
  Packs<Real> packs;
  Grid<Real> grid;
  Laws<Real> laws;
  std::size_t strayed = 0;            ///< points outside their home cell, summed over the steps
  bool kept = false;                  ///< the last step kept the motion
  std::vector<GroupRest> rest;        ///< of the groups of columns
  std::vector<std::uint8_t> yielded;  ///< groups with points that have yielded in the last step
  std::int64_t steps = 0;
  std::size_t stepped = 0;  ///< points that the last step moved
  bool wakes = false;       ///< ground at rest has to be woken
};

/// Energies, forces and momentum of one step.
struct StepSums {
  GridSums grid;
  PointSums points;
};

/// A model without points.
template <class Real>
Model<Real> empty_model(const GridSize& size, const LawTable& laws, const ModelSettings& settings);

/// A model of the particles, their sums on the grid. Left empty where a particle is off the grid.
template <class Real>
std::optional<Model<Real>> make_model(const Particles& particles, const GridSize& size,
                                      const LawTable& laws, const ModelSettings& settings = {});

/// The same points in another number type, with other settings; all ground is awake.
/// @pre no point has strayed; packs.motion holds their motion
template <class To, class From>
Model<To> converted(const Model<From>& from, const GridSize& size, const LawTable& laws,
                    const ModelSettings& settings);

/// Other laws for the same points.
template <class Real>
void take_laws(Model<Real>& model, const LawTable& laws);

/// Adds all points to the sums, in the order in which a step does; of ground at rest those that
/// moving ground feels.
/// @pre packs.motion holds their motion, or the model is held
template <class Real>
void spread_all(Model<Real>& model);

/// The sums of the grid made anew from the points.
template <class Real>
void spread_anew(Model<Real>& model);

/// Steps all ground again, resting ground too.
/// @pre as spread_all
template <class Real>
void wake(Model<Real>& model);

/// One explicit step: momentum balance on the nodes, stress and position of the points, their sums
/// for the next step (symplectic Euler, stress updated last). `keep`: the motion can be read
/// afterwards. Every 32nd step keeps it too, and lays to rest the ground that has come to rest.
/// The same bytes for any number of threads.
/// @pre no point has moved by more than a cell since it was put into its cell
template <class Real>
StepSums step(Model<Real>& model, const StepSettings& settings, bool keep, ThreadTeam& team);

/// The first half of a step alone: the balance of the nodes. The sums of the grid are zero after.
template <class Real>
GridSums balance_nodes(Model<Real>& model, const StepSettings& settings, ThreadTeam& team);

/// The second half alone: the points by the velocities that stand on the nodes, and their sums.
template <class Real>
PointSums move_points(Model<Real>& model, const StepSettings& settings, bool keep,
                      ThreadTeam& team);

/// Largest slope that the velocities of the nodes have at the points, 1/s.
template <class Real>
double steepest(Model<Real>& model);

/// Puts every point into the cell it has moved to.
/// @return false where a point has left the grid; nothing is changed then
template <class Real>
bool tidy_up(Model<Real>& model);

/// Whether so many points have strayed that tidying up is the cheaper way on.
template <class Real>
bool is_untidy(const Model<Real>& model);

/// Relative difference of mass and momentum between points and nodes. Wakes all ground.
/// @pre the last step kept the motion
template <class Real>
Balances transfer_balance(Model<Real>& model);

}  // namespace leda::solver
