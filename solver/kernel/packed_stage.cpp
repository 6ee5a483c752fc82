#include "solver/kernel/packed_stage.hpp"

#include <algorithm>
#include <cmath>

#include "solver/kernel/rehome.hpp"

namespace leda::solver {

namespace {

// A stray costs a step about five times what a point at home does, and once as much to be put into
// its new cell: strays that add up to this share of all over the steps are worth it.
constexpr std::size_t share_that_strays = 200;

double plane_sum(const PackGrid& grid, std::size_t column, std::size_t value) {
  const std::size_t planes = PackGrid::planes, first = (column * PackGrid::values + value) * planes;
  double sum = 0;
  for (std::size_t i = first * grid.stride; i < (first + planes) * grid.stride; ++i) {
    sum += static_cast<double>(grid.sums[i]);
  }
  return sum;
}

void add(const GridSums& nodes, const ParticleSums& points, StepSums& sums) {
  sums.grid.kinetic_before += nodes.kinetic_before;
  sums.grid.kinetic_after += nodes.kinetic_after;
  sums.grid.damping_work += nodes.damping_work;
  sums.particles.stress_work += points.stress_work;
  sums.particles.momentum_x += points.momentum_x;
  sums.particles.momentum_z += points.momentum_z;
  sums.particles.fastest_squared = std::max(sums.particles.fastest_squared, points.fastest_squared);
}

constexpr std::int64_t steps_between_decisions = 32;

double width(const PackedStage& stage) {
  return static_cast<double>(columns_of_a_group) * stage.grid.h;
}

// Resting packs of group g that moving ground on the right feels; none are felt on the left, since
// a point gives to its own column of nodes and the two after it. Packs that do not stand in order
// count as felt: what resting nodes are given is cleared before it can matter.
std::size_t first_felt(const PackedStage& stage, std::size_t g) {
  const PackGroup& group = stage.packs.group[g];
  if (g + 1 >= stage.rest.size() || stage.rest[g + 1].rests) return group.end();
  std::size_t first = group.first + group.in_order;
  const std::size_t column = (g + 1) * columns_of_a_group - 2;
  while (first > group.first && stage.packs.place[first - 1].column >= column) --first;
  return first;
}

void spread_group(PackedStage& stage, std::size_t g) {
  const PackGroup& group = stage.packs.group[g];
  spread(stage.packs, stage.grid, stage.rest[g].rests ? first_felt(stage, g) : group.first,
         group.end());
}

// What rests has no velocity, at its points and at its nodes.
void still(PackedStage& stage) {
  PackGrid& grid = stage.grid;
  for (std::size_t g = 0; g < stage.rest.size(); ++g) {
    if (!stage.rest[g].rests) continue;
    const PackGroup& group = stage.packs.group[g];
    for (std::size_t i = group.first; i < group.end(); ++i) stage.packs.motion[i] = {};
    const std::size_t first = g * columns_of_a_group;
    const std::size_t last = std::min(first + columns_of_a_group, grid.columns);
    std::fill_n(&grid.velocity[first * 2 * grid.stride], (last - first) * 2 * grid.stride, Real{0});
  }
}

void spread_anew(PackedStage& stage) {
  std::fill(stage.grid.sums.begin(), stage.grid.sums.end(), Real{0});
  spread_all(stage);
}

}  // namespace

bool packs_can_run(const Grid& grid, const LawTable& laws) {
  return !grid.averages() && laws.viscous.empty();
}

PackedStage empty_packed_stage(const Grid& grid, const LawTable& laws, bool softer) {
  PackedStage stage;
  stage.grid = make_pack_grid(grid, softer);
  stage.laws = pack_laws(laws, softer);
  return stage;
}

std::optional<PackedStage> begin_packed_stage(const Particles& particles, const Grid& grid,
                                              const LawTable& laws, bool softer) {
  PackedStage stage = empty_packed_stage(grid, laws, softer);
  if (!pack(particles, stage.grid, stage.packs)) return {};
  stage.rest.assign(stage.packs.group.size(), GroupRest{});
  spread_all(stage);
  return stage;
}

void spread_all(PackedStage& stage) {
  for (const std::size_t first : {0U, 1U}) {
    for (std::size_t g = first; g < stage.rest.size(); g += 2) spread_group(stage, g);
  }
}

StepSums step(PackedStage& stage, const StepSettings& settings, bool keep, Team& team,
              bool& left_grid) {
  const std::size_t groups = stage.rest.size();
  const bool decides = ++stage.steps % steps_between_decisions == 0 || stage.wakes;
  stage.kept = keep || decides;
  std::vector<GridSums> nodes(groups);
  team.run(groups, [&](std::size_t g) {
    if (stage.rest[g].rests) return;
    const std::size_t first = std::max<std::size_t>(1, g * columns_of_a_group);
    const std::size_t last = std::min((g + 1) * columns_of_a_group, stage.grid.columns - 1);
    const GridStep grid_step{settings.dt, settings.gravity, settings.damping};
    nodes[g] = update_columns(stage.grid, grid_step, first, last);
  });
  std::vector<PackSums> points(groups);
  for (const std::size_t first : {0U, 1U}) {  // neighbours share nodes, so they wait for each other
    team.run((groups + 1 - first) / 2, [&](std::size_t i) {
      const std::size_t g = first + 2 * i;
      if (stage.rest[g].rests) return spread_group(stage, g);
      const PackGroup& group = stage.packs.group[g];
      points[g] = step_packs(stage.packs, stage.grid, stage.laws, settings.dt, stage.kept,
                             group.first, group.end());
    });
  }
  StepSums sums;
  left_grid = false;
  stage.stepped = 0;
  for (std::size_t g = 0; g < groups; ++g) {
    if (!stage.rest[g].rests) stage.stepped += stage.packs.group[g].points;
    add(nodes[g], points[g].particles, sums);
    stage.strayed += points[g].strayed;
    left_grid = left_grid || points[g].left_grid;
  }
  stage.wakes = observe(stage.rest, points, settings.dt, width(stage));
  if (decides && settings.ground_rests && !left_grid && decide(stage.rest, width(stage))) {
    still(stage);
    spread_anew(stage);
    stage.wakes = false;
  }
  return sums;
}

bool tidy_up(PackedStage& stage) {
  stage.strayed = 0;
  return rehome_strays(stage.packs, stage.grid);
}

bool is_untidy(const PackedStage& stage) {
  return stage.strayed * share_that_strays > stage.packs.count;
}

Balances transfer_balance(PackedStage& stage) {
  stage.rest.assign(stage.rest.size(), GroupRest{});
  spread_anew(stage);
  double node[3] = {}, mass = 0, x = 0, z = 0, size = 0;
  for (std::size_t column = 0; column < stage.grid.columns; ++column) {
    for (std::size_t v = 0; v < 3; ++v) node[v] += plane_sum(stage.grid, column, v);
  }
  for (std::size_t i = 0; i < stage.packs.pack.size(); ++i) {
    for (std::size_t l = 0; l < Pack::lanes; ++l) {
      const auto m = static_cast<double>(stage.packs.pack[i].mass[l]);
      const auto vx = static_cast<double>(stage.packs.motion[i].vx[l]);
      const auto vz = static_cast<double>(stage.packs.motion[i].vz[l]);
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
