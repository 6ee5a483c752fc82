#include "solver/run/initial_stress.hpp"

#include <algorithm>
#include <cmath>

#include "solver/statics/statics.hpp"

namespace leda::solver {

namespace {

constexpr double balanced = 1e-4;  // unbalanced force over weight
constexpr int most_elastic_steps = 6000;
constexpr int most_plastic_steps = 6000;
constexpr int steps_between_looks = 25;

struct Balance {
  bool reached = false;
  double ratio = 1;
};

Model<double>& quiet_model(RunState& run) { return std::get<Model<double>>(run.model); }

double ratio_of(const RunState& run) {
  const GridSums& sums = run.node_sums;
  return sums.weight > 0 ? sums.unbalanced_force / sums.weight : 0.0;
}

std::optional<StageEnd> relax(RunState& run, int most_steps, const char* stage, Balance& balance) {
  spread_anew(quiet_model(run));
  run.audit = begin_audit(run.model, run.seeded.laws);
  for (int i = 1; i <= most_steps; ++i) {
    if (auto end = advance(run, run.settings->damping.initial, false)) return end;
    if (i % steps_between_looks != 0) continue;
    balance.ratio = ratio_of(run);
    if (balance.ratio < balanced) {
      balance.reached = true;
      return {};
    }
    if (run.listener->interrupted && run.listener->interrupted()) {
      return StageEnd{StageEnd::Why::interrupted, ""};
    }
    if (run.listener->progress && i % (8 * steps_between_looks) == 0) {
      run.listener->progress({0.0, 0.0, stage});
    }
  }
  return {};
}

void zero_motion(Model<double>& model) {
  std::ranges::fill(model.packs.motion, PackMotion<double>{});
  for (auto& pack : model.packs.pack) {
    std::ranges::fill(pack.plastic_strain, 0.0);
    std::ranges::fill(pack.plastic_rest, 0.0);
  }
  spread_anew(model);
}

// A balance by static solves. Left unreached where there is none, or none the statics can find.
std::optional<StageEnd> solve(RunState& run, const Statics& statics, const char* stage,
                              Balance& balance) {
  if (run.listener->progress) run.listener->progress({0.0, 0.0, stage});
  const StaticBalance found =
      statics.balance(quiet_model(run), *run.team, run.listener->interrupted);
  zero_motion(quiet_model(run));
  if (found.end == StaticBalance::End::interrupted) {
    return StageEnd{StageEnd::Why::interrupted, ""};
  }
  balance = {found.end == StaticBalance::End::balanced, found.ratio};
  return {};
}

std::optional<StageEnd> settle(RunState& run, const std::optional<Statics>& statics, bool elastic,
                               Balance& balance) {
  take_laws(quiet_model(run), without_softening(run.seeded.laws, elastic));
  const char* stage = elastic ? "initial stress" : "undrained";
  balance = {};
  if (statics) {
    if (auto end = solve(run, *statics, stage, balance)) return end;
  }
  if (!balance.reached) {
    const int most = elastic ? most_elastic_steps : most_plastic_steps;
    if (auto end = relax(run, most, stage, balance)) return end;
  }
  zero_motion(quiet_model(run));
  return {};
}

// Without the room above the ground, which nothing reaches while it is held.
GridSize quiet_size(const Seeded& seeded) {
  double highest = 0;
  for (const Particle& p : seeded.particles) highest = std::max(highest, p.z);
  GridSize size = seeded.size;
  size.rows = std::min(size.rows, static_cast<std::size_t>(highest / size.h) + 6);
  return size;
}

}  // namespace

void begin_quiet(RunState& run) {
  const ModelSettings settings{.softer = false,
                               .averages = run.seeded.averages,
                               .keeps_force = true,
                               .rests = false,
                               .held = true};
  // Seeds stand under the ground, so all of them lie on the grid.
  run.model = make_model<double>(run.seeded.particles, quiet_size(run.seeded),
                                 without_softening(run.seeded.laws, true), settings)
                  .value();
  Particles().swap(run.seeded.particles);  // an assignment would keep the memory
}

std::optional<StageEnd> find_initial_stress(RunState& run, QuietMethod method) {
  if (!run.team) run.team = std::make_shared<ThreadTeam>(1);
  Balance balance;
  std::optional<Statics> statics;
  if (method == QuietMethod::direct) {
    statics = Statics::prepare(quiet_model(run), run.seeded.laws, *run.team);
  }
  if (auto end = settle(run, statics, true, balance)) return end;
  if (auto end = settle(run, statics, false, balance)) return end;
  if (!balance.reached) {
    run.warnings.push_back("no equilibrium at the peak strength (unbalanced force " +
                           std::to_string(balance.ratio * 100) +
                           " % of the weight): the section slides without softening");
  }
  run.fastest = 0;
  run.time = 0;
  return {};
}

void begin_moving(RunState& run) {
  const auto moving = [&]<class Real>(Real) {
    run.model = with_model(run.model, [&](const auto& model) -> AnyModel {
      return converted<Real>(model, run.seeded.size, laws_now(run), moving_settings(run));
    });
  };
  run.settings->precision == Precision::double_precision ? moving(double{}) : moving(float{});
}

}  // namespace leda::solver
