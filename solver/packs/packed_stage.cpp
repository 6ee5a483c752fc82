#include "solver/packs/packed_stage.hpp"

#include <cmath>

namespace leda::solver {

namespace {

// Strays cost about thirty times a point that is at home, and arranging all anew about as much as
// one step: steps with strayed points that add up to this share of all are worth one arrangement.
constexpr std::size_t share_that_strays = 6;

double plane_sum(const PackGrid& grid, std::size_t column, std::size_t value) {
  const std::size_t planes = PackGrid::planes, first = (column * PackGrid::values + value) * planes;
  double sum = 0;
  for (std::size_t i = first * grid.stride; i < (first + planes) * grid.stride; ++i) {
    sum += static_cast<double>(grid.sums[i]);
  }
  return sum;
}

}  // namespace

bool packs_can_run(const Grid& grid, const LawTable& laws) {
  return !grid.averages() && laws.viscous.empty();
}

std::optional<PackedStage> begin_packed_stage(const Particles& particles, const Grid& grid,
                                              const LawTable& laws) {
  PackedStage stage;
  stage.grid = make_pack_grid(grid);
  stage.laws = pack_laws(laws);
  if (!pack(particles, stage.grid, stage.packs)) return {};
  spread(stage.packs, stage.grid);
  return stage;
}

StepSums step(PackedStage& stage, const StepSettings& settings, bool keep, bool& left_grid) {
  StepSums sums;
  sums.grid = update_velocity(stage.grid, {settings.dt, settings.gravity, settings.damping});
  const PackSums points = step_packs(stage.packs, stage.grid, stage.laws, settings.dt, keep);
  sums.particles = points.particles;
  stage.strayed += points.strayed;
  stage.kept = keep;
  left_grid = points.left_grid;
  return sums;
}

bool is_untidy(const PackedStage& stage) {
  return stage.strayed * share_that_strays > stage.packs.count;
}

Balances transfer_balance(const PackedStage& stage) {
  double node[3] = {}, mass = 0, x = 0, z = 0, size = 0;
  for (std::size_t column = 0; column < stage.grid.columns; ++column) {
    for (std::size_t v = 0; v < 3; ++v) node[v] += plane_sum(stage.grid, column, v);
  }
  for (std::size_t i = 0; i < stage.packs.pack.size(); ++i) {
    for (std::size_t l = 0; l < Pack::lanes; ++l) {
      const double m = static_cast<double>(stage.packs.pack[i].mass[l]);
      const double vx = static_cast<double>(stage.packs.motion[i].vx[l]);
      const double vz = static_cast<double>(stage.packs.motion[i].vz[l]);
      mass += m;
      x += m * vx;
      z += m * vz;
      size += m * std::hypot(vx, vz);
    }
  }
  Balances balances;
  balances.mass = mass > 0 ? std::abs(node[0] - mass) / mass : 0.0;
  balances.momentum = size > 0 ? std::hypot(node[1] - x, node[2] - z) / size : 0.0;
  return balances;
}

}  // namespace leda::solver
