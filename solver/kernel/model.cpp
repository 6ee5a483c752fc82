#include "solver/kernel/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/kernel/band.hpp"
#include "solver/kernel/group.hpp"
#include "solver/kernel/pack_particles.hpp"
#include "solver/kernel/rehome.hpp"

namespace leda::solver {

namespace {

// A stray costs a step about five times what a point at home does, and once as much to be put into
// its new cell: strays that add up to this share of all over the steps are worth it.
constexpr std::size_t share_that_strays = 200;

constexpr std::int64_t steps_between_decisions = 32;

template <class Real>
double width(const Model<Real>& model) {
  return static_cast<double>(columns_of_a_group) * model.grid.h;
}

// The columns of group g.
template <class Real>
std::pair<std::size_t, std::size_t> columns(const Model<Real>& model, std::size_t g) {
  const std::size_t first = g * columns_of_a_group;
  return {first, std::min(first + columns_of_a_group, model.grid.columns)};
}

template <class Real>
double plane_sum(const Grid<Real>& grid, std::size_t column, std::size_t value) {
  constexpr std::size_t planes = Grid<Real>::planes;
  const std::size_t first = (column * Grid<Real>::values + value) * planes;
  double sum = 0;
  for (std::size_t i = first * grid.stride; i < (first + planes) * grid.stride; ++i) {
    sum += static_cast<double>(grid.sums[i]);
  }
  return sum;
}

void add(const GridSums& of, GridSums& sums) {
  sums.kinetic_before += of.kinetic_before;
  sums.kinetic_after += of.kinetic_after;
  sums.damping_work += of.damping_work;
  sums.unbalanced_force += of.unbalanced_force;
  sums.weight += of.weight;
}

void add(const PointSums& of, PointSums& sums) {
  sums.stress_work += of.stress_work;
  sums.momentum_x += of.momentum_x;
  sums.momentum_z += of.momentum_z;
  sums.fastest_squared = std::max(sums.fastest_squared, of.fastest_squared);
  sums.strayed += of.strayed;
  sums.left_grid = sums.left_grid || of.left_grid;
  sums.yields = sums.yields || of.yields;
}

// The first pack of resting group g whose points reach nodes of a moving group on its right. On the
// left there is none: a point gives to its own column of nodes and to the two on its right. Packs
// that do not stand in order always count: the sums of resting nodes are made anew before they are
// used.
template <class Real>
std::size_t first_felt(const Model<Real>& model, std::size_t g) {
  const PackGroup& group = model.packs.group[g];
  if (g + 1 >= model.rest.size() || model.rest[g + 1].rests) return group.end();
  std::size_t first = group.first + group.in_order;
  const std::size_t column = (g + 1) * columns_of_a_group - 2;
  while (first > group.first && model.packs.place[first - 1].column >= column) --first;
  return first;
}

template <class Real>
void clear_spans(Model<Real>& model, std::size_t g) {
  const auto [first, last] = columns(model, g);
  const std::size_t column = 2 * model.grid.stride;
  std::fill_n(&model.grid.span[first * column], (last - first) * column, Real{0});
}

// False where a point has left the grid.
template <class Real>
bool spread_group(Model<Real>& model, std::size_t g) {
  const PackGroup& group = model.packs.group[g];
  const std::size_t first = model.rest[g].rests ? first_felt(model, g) : group.first;
  if (first == group.end()) return true;
  if (model.grid.averages()) {
    clear_spans(model, g);
    model.kernel->add_stress(model.packs, model.grid, group.first, group.end());
  }
  return model.kernel->spread(model.packs, model.grid, first, group.end());
}

// Calls part(g) for every group, even ones before odd ones, each on any thread: neighbours share
// nodes, so they wait for each other.
template <class Part>
void by_turns(std::size_t groups, ThreadTeam& team, const Part& part) {
  for (const std::size_t first : {0U, 1U}) {
    team.run((groups + 1 - first) / 2, [&](std::size_t i) { part(first + 2 * i); });
  }
}

// What rests has no velocity, at its points and at its nodes.
template <class Real>
void still(Model<Real>& model) {
  Grid<Real>& grid = model.grid;
  for (std::size_t g = 0; g < model.rest.size(); ++g) {
    if (!model.rest[g].rests) continue;
    const PackGroup& group = model.packs.group[g];
    for (std::size_t i = group.first; i < group.end(); ++i) model.packs.motion[i] = {};
    const auto [first, last] = columns(model, g);
    std::fill_n(&grid.velocity[first * 2 * grid.stride], (last - first) * 2 * grid.stride, Real{0});
  }
}

// Points by the velocities of the nodes, in one pass, or, where spans are averaged, in two: spans
// need all of their points before one of them can be updated.
template <class Real>
std::vector<PointSums> update_points(Model<Real>& model, const StepSettings& settings,
                                     ThreadTeam& team) {
  std::vector<PointSums> of(model.rest.size());
  const auto update = [&](std::size_t g) {
    const PackGroup& group = model.packs.group[g];
    of[g] = model.kernel->step(model.packs, model.grid, model.laws, settings, model.kept,
                               group.first, group.end());
  };
  if (!model.grid.averages()) {
    by_turns(of.size(), team, [&](std::size_t g) {
      model.rest[g].rests ? static_cast<void>(spread_group(model, g)) : update(g);
    });
    return of;
  }
  team.run(of.size(), [&](std::size_t g) {
    if (model.rest[g].rests) return;
    clear_spans(model, g);
    const PackGroup& group = model.packs.group[g];
    model.kernel->add_dilation(model.packs, model.grid, group.first, group.end());
    update(g);
  });
  const bool inside = !settings.move || rehome_strays(model.packs, model.grid);
  by_turns(of.size(), team, [&](std::size_t g) {
    of[g].left_grid = !spread_group(model, g) || !inside || of[g].left_grid;
  });
  return of;
}

// Takes note of what moved, lays ground to rest and wakes it.
template <class Real>
void decide_rest(Model<Real>& model, const std::vector<PointSums>& of, double dt, bool decides) {
  model.wakes = observe(model.rest, of, dt, width(model));
  if (!decides || !decide(model.rest, width(model))) return;
  still(model);
  spread_anew(model);
  model.wakes = false;
}

// Rounding must not carry a point over the edge of its cell.
template <class To>
constexpr To below_one = To{1} - std::numeric_limits<To>::epsilon() / 2;

template <class From, class To>
void convert(const Pack<From>& from, Pack<To>& to) {
  for (std::size_t n = 0; n < point_numbers<From>.size(); ++n) {
    std::ranges::transform(from.*point_numbers<From>[n].lane, to.*point_numbers<To>[n].lane,
                           [](From value) { return static_cast<To>(value); });
  }
  for (auto* at : {to.x, to.z}) {
    for (std::size_t l = 0; l < Pack<To>::lanes; ++l) at[l] = std::min(at[l], below_one<To>);
  }
  std::ranges::copy(from.law, to.law);
  std::ranges::copy(from.id, to.id);
}

template <class From, class To>
void convert(const PackMotion<From>& from, PackMotion<To>& to) {
  for (std::size_t n = 0; n < motion_numbers<From>.size(); ++n) {
    std::ranges::transform(from.*motion_numbers<From>[n].lane, to.*motion_numbers<To>[n].lane,
                           [](From value) { return static_cast<To>(value); });
  }
}

template <class From, class To>
void copy_group(const Packs<From>& packs, std::size_t g, Packs<To>& to) {
  const PackGroup& of = packs.group[g];
  make_room(to, g, to.held ? of.in_use : std::max(of.in_use, most_in_use(of.in_order)));
  PackGroup& group = to.group[g];
  group.in_use = of.in_use;
  group.in_order = of.in_order;
  group.points = of.points;
  for (std::size_t i = 0; i < of.in_use; ++i) {
    convert(packs.pack[of.first + i], to.pack[group.first + i]);
    if (to.moves && packs.moves) convert(packs.motion[of.first + i], to.motion[group.first + i]);
    to.place[group.first + i] = packs.place[of.first + i];
    to.taken[group.first + i] = packs.taken[of.first + i];
    to.strayed[group.first + i] = packs.strayed[of.first + i];
  }
}

}  // namespace

template <class Real>
Model<Real> empty_model(const GridSize& size, const LawTable& laws, const ModelSettings& settings) {
  Model<Real> model;
  model.settings = settings;
  model.grid = make_grid<Real>(size, {.mass = settings.softer || settings.keeps_force,
                                      .force = settings.keeps_force,
                                      .averages = settings.averages,
                                      .band_m = laws.band_m});
  model.packs.held = settings.held;
  model.packs.moves = !settings.held || settings.averages;  // spans are spread from the motion
  take_laws(model, laws);
  return model;
}

template <class Real>
std::optional<Model<Real>> make_model(const Particles& particles, const GridSize& size,
                                      const LawTable& laws, const ModelSettings& settings) {
  Model<Real> model = empty_model<Real>(size, laws, settings);
  if (!pack(particles, model.grid, model.packs)) return {};
  model.rest.assign(model.packs.group.size(), GroupRest{});
  model.yielded.assign(model.rest.size(), 1);  // perhaps
  spread_all(model);
  return model;
}

template <class To, class From>
Model<To> converted(const Model<From>& from, const GridSize& size, const LawTable& laws,
                    const ModelSettings& settings) {
  Model<To> model = empty_model<To>(size, laws, settings);
  const Packs<From>& packs = from.packs;
  Packs<To>& to = model.packs;
  begin_groups(to, model.grid);
  to.count = packs.count;
  to.column = packs.column;
  for (std::size_t g = 0; g < packs.group.size(); ++g) copy_group(packs, g, to);
  set_all_tops(to, model.grid);
  model.rest.assign(to.group.size(), GroupRest{});
  model.yielded.assign(model.rest.size(), 1);
  spread_all(model);
  return model;
}

template <class Real>
void take_laws(Model<Real>& model, const LawTable& laws) {
  model.laws = narrow_laws<Real>(laws, model.settings.softer);
}

template <class Real>
void spread_all(Model<Real>& model) {
  ThreadTeam alone(1);
  by_turns(model.rest.size(), alone, [&](std::size_t g) { spread_group(model, g); });
}

template <class Real>
void spread_anew(Model<Real>& model) {
  std::ranges::fill(model.grid.sums, Real{0});
  std::ranges::fill(model.grid.band.sums, Real{0});
  spread_all(model);
}

template <class Real>
void wake(Model<Real>& model) {
  model.rest.assign(model.rest.size(), GroupRest{});
  spread_anew(model);
}

template <class Real>
GridSums balance_nodes(Model<Real>& model, const StepSettings& settings, ThreadTeam& team) {
  std::vector<GridSums> of(model.rest.size());
  team.run(of.size(), [&](std::size_t g) {
    if (model.rest[g].rests) return;
    const auto [first, last] = columns(model, g);
    of[g] = model.kernel->update_columns(model.grid, settings, std::max<std::size_t>(1, first),
                                         std::min(last, model.grid.columns - 1));
  });
  GridSums sums;
  for (const GridSums& one : of) add(one, sums);
  return sums;
}

template <class Real>
StepSums step(Model<Real>& model, const StepSettings& settings, bool keep, ThreadTeam& team) {
  const bool decides =
      model.settings.rests && (++model.steps % steps_between_decisions == 0 || model.wakes);
  model.kept = model.packs.moves && (keep || decides || model.grid.averages());
  StepSums sums;
  sums.grid = balance_nodes(model, settings, team);
  average_band(model, team);
  const std::vector<PointSums> points = update_points(model, settings, team);
  model.stepped = 0;
  for (std::size_t g = 0; g < points.size(); ++g) {
    if (!model.rest[g].rests) model.stepped += model.packs.group[g].points;
    model.yielded[g] = points[g].yields ? 1 : 0;
    add(points[g], sums.points);
  }
  model.strayed += sums.points.strayed;
  if (model.settings.rests && !sums.points.left_grid) {
    decide_rest(model, points, settings.dt, decides);
  }
  return sums;
}

template <class Real>
PointSums move_points(Model<Real>& model, const StepSettings& settings, bool keep,
                      ThreadTeam& team) {
  model.kept = model.packs.moves && (keep || model.grid.averages());
  PointSums sums;
  for (const PointSums& one : update_points(model, settings, team)) add(one, sums);
  return sums;
}

template <class Real>
double steepest(Model<Real>& model) {
  return model.kernel->steepest(model.packs, model.grid, 0, model.packs.pack.size());
}

template <class Real>
bool tidy_up(Model<Real>& model) {
  model.strayed = 0;
  return rehome_strays(model.packs, model.grid);
}

template <class Real>
bool is_untidy(const Model<Real>& model) {
  return model.strayed * share_that_strays > model.packs.count;
}

template <class Real>
Balances transfer_balance(Model<Real>& model) {
  wake(model);
  double node[3] = {}, mass = 0, x = 0, z = 0, size = 0;
  for (std::size_t column = 0; column < model.grid.columns; ++column) {
    for (std::size_t v = 0; v < 3; ++v) node[v] += plane_sum(model.grid, column, v);
  }
  for_each_point(model.packs, [&](std::size_t i, std::size_t l) {
    const auto m = static_cast<double>(model.packs.pack[i].mass[l]);
    mass += m;
    if (!model.packs.moves) return;
    const auto vx = static_cast<double>(model.packs.motion[i].vx[l]);
    const auto vz = static_cast<double>(model.packs.motion[i].vz[l]);
    x += m * vx;
    z += m * vz;
    size += m * std::hypot(vx, vz);
  });
  Balances balances;
  balances.mass = mass > 0 ? std::abs(node[0] - mass) / mass : 0.0;
  balances.momentum = size > 0 ? std::hypot(node[1] - x, node[2] - z) / size : 0.0;
  return balances;
}

#define LEDA_INSTANCES(Real)                                                                \
  template Model<Real> empty_model(const GridSize&, const LawTable&, const ModelSettings&); \
  template std::optional<Model<Real>> make_model(const Particles&, const GridSize&,         \
                                                 const LawTable&, const ModelSettings&);    \
  template Model<Real> converted(const Model<float>&, const GridSize&, const LawTable&,     \
                                 const ModelSettings&);                                     \
  template Model<Real> converted(const Model<double>&, const GridSize&, const LawTable&,    \
                                 const ModelSettings&);                                     \
  template GridSums balance_nodes(Model<Real>&, const StepSettings&, ThreadTeam&);          \
  template void take_laws(Model<Real>&, const LawTable&);                                   \
  template void spread_all(Model<Real>&);                                                   \
  template void spread_anew(Model<Real>&);                                                  \
  template void wake(Model<Real>&);                                                         \
  template StepSums step(Model<Real>&, const StepSettings&, bool, ThreadTeam&);             \
  template PointSums move_points(Model<Real>&, const StepSettings&, bool, ThreadTeam&);     \
  template double steepest(Model<Real>&);                                                   \
  template bool tidy_up(Model<Real>&);                                                      \
  template bool is_untidy(const Model<Real>&);                                              \
  template Balances transfer_balance(Model<Real>&);
LEDA_INSTANCES(float)
LEDA_INSTANCES(double)
#undef LEDA_INSTANCES

}  // namespace leda::solver
