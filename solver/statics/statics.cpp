#include "solver/statics/statics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "solver/section/section.hpp"
#include "solver/statics/accelerator.hpp"
#include "solver/statics/stiffness.hpp"

namespace leda::solver {

namespace {

constexpr double aimed_ratio = 1e-6;     // unbalanced force over weight
constexpr double accepted_ratio = 1e-4;  // where the rounds run out: as good as the relaxation
constexpr int most_rounds = 80;
constexpr int remembered = 8;
constexpr double filling = 1e-6;  // of a full cell's stiffness, where few particles hold a node
constexpr double most_bytes = 1e9;
// One stress update takes the whole increment: its rotation is linearised, and a slide that has
// no balance shows by growing without end.
constexpr double most_gradient = 0.5;

// The stresses that a new trial starts from, without plastic strain.
class StressState {
 public:
  explicit StressState(const Packs<double>& packs) : kept_(packs.pack.size()) {
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      for (std::size_t n = 0; n < stresses.size(); ++n) {
        std::ranges::copy(packs.pack[i].*stresses[n], kept_[i][n].begin());
      }
    }
  }

  void restore(Packs<double>& packs) const {
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      for (std::size_t n = 0; n < stresses.size(); ++n) {
        std::ranges::copy(kept_[i][n], packs.pack[i].*stresses[n]);
      }
      std::ranges::fill(packs.pack[i].plastic_strain, 0.0);
      std::ranges::fill(packs.pack[i].plastic_rest, 0.0);
    }
  }

 private:
  using P = Pack<double>;
  static constexpr std::array stresses = {&P::sxx, &P::szz, &P::sxz, &P::syy};
  std::vector<std::array<std::array<double, P::lanes>, stresses.size()>> kept_;
};

// The unbalanced force is left in the grid, whose sums are zero then.
GridSums unbalanced(Model<double>& model, ThreadTeam& team) {
  return balance_nodes(model, {0.0, gravity, 0.0, false}, team);
}

}  // namespace

std::optional<Statics> Statics::prepare(Model<double>& model, const LawTable& laws,
                                        ThreadTeam& team) {
  unbalanced(model, team);
  Freedoms freedoms = number_freedoms(model.grid);
  if (freedoms.count() == 0 || ColumnMatrix::bytes(freedoms) > most_bytes) return {};
  ColumnMatrix factor = elastic_stiffness(model, laws, freedoms, filling);
  if (!factor.factorize()) return {};
  return Statics(std::move(freedoms), std::move(factor));
}

StaticBalance Statics::balance(Model<double>& model, ThreadTeam& team,
                               const std::function<bool()>& interrupted) const {
  using Vector = ColumnMatrix::Vector;
  using End = StaticBalance::End;
  StaticBalance result;
  const StressState start(model.packs);
  Accelerator accelerator(freedoms_.count(), remembered);
  Vector displacement = Vector::Zero(freedoms_.count()), force(freedoms_.count());
  for (; result.rounds < most_rounds; ++result.rounds) {
    if (interrupted && interrupted()) {
      result.end = End::interrupted;
      break;
    }
    start.restore(model.packs);
    set_displacement(freedoms_, displacement.data(), model.grid);
    if (!(steepest(model) < most_gradient)) break;
    // Displacement as a velocity over one second: the transfers of a step, nothing of its own.
    move_points(model, {1.0, 0.0, 0.0, false}, false, team);
    const GridSums sums = unbalanced(model, team);
    result.ratio = sums.weight > 0 ? sums.unbalanced_force / sums.weight : 0.0;
    if (!std::isfinite(result.ratio)) break;
    const bool last = result.rounds + 1 == most_rounds;
    if (result.ratio < aimed_ratio || (last && result.ratio < accepted_ratio)) {
      result.end = End::balanced;
      return result;
    }
    gather_force(freedoms_, model.grid, force.data());
    Vector correction = force;
    factor_.solve(correction);
    displacement = accelerator.next(displacement, correction, force);
  }
  start.restore(model.packs);
  return result;
}

}  // namespace leda::solver
