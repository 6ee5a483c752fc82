#include "solver/kernel/rehome.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "solver/kernel/group.hpp"
#include "solver/kernel/pack_particles.hpp"

namespace leda::solver {

namespace {

struct Stray {
  std::size_t pack, lane;
  PackPlace home;
};

std::size_t group_of(std::uint32_t column) { return column / columns_of_a_group; }

LaneBits bit(std::size_t lane) { return static_cast<LaneBits>(1U << lane); }

// The strays of a pack; false where one of them has left the grid.
template <class Real>
bool find_strays(const Packs<Real>& packs, const Grid<Real>& grid, std::size_t i,
                 std::vector<Stray>& strays) {
  const Pack<Real>& p = packs.pack[i];
  const PackPlace& place = packs.place[i];
  for (LaneBits left = packs.strayed[i]; left != 0;
       left = static_cast<LaneBits>(left & (left - 1))) {
    const auto l = static_cast<std::size_t>(std::countr_zero(left));
    const double right = std::floor(static_cast<double>(p.x[l]));
    const double up = std::floor(static_cast<double>(p.z[l]));
    const double column = place.column + right,
                 row = place.row + static_cast<double>(l % Pack<Real>::rows) + up;
    if (!on_grid(grid, column, row)) return false;
    strays.push_back({i, l, {static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row)}});
  }
  return true;
}

template <class Real>
std::optional<std::vector<Stray>> find_strays(const Packs<Real>& packs, const Grid<Real>& grid) {
  std::vector<Stray> strays;
  for (std::size_t i = 0; i < packs.strayed.size(); ++i) {
    if (packs.strayed[i] != 0 && !find_strays(packs, grid, i, strays)) return {};
  }
  return strays;
}

template <class Real>
PointAtHome<Real> take_out(Packs<Real>& packs, const Stray& stray) {
  Pack<Real>& p = packs.pack[stray.pack];
  p.x[stray.lane] -= std::floor(p.x[stray.lane]);
  p.z[stray.lane] -= std::floor(p.z[stray.lane]);
  const PackedPoint<Real> point = take_point(packs, stray.pack, stray.lane);
  put_point(no_point<Real>(point.law), packs, stray.pack, stray.lane);
  packs.strayed[stray.pack] = 0;
  packs.taken[stray.pack] = static_cast<LaneBits>(packs.taken[stray.pack] & ~bit(stray.lane));
  --packs.group[group_of(packs.place[stray.pack].column)].points;
  return {stray.home, point};
}

struct Lane {
  std::size_t pack, lane;
};

// A lane of pack i for a point of this home.
template <class Real>
std::optional<Lane> free_lane(const Packs<Real>& packs, std::size_t i, const PackPlace& home) {
  const PackPlace& place = packs.place[i];
  if (place.column != home.column || home.row < place.row) return {};
  const std::size_t row = home.row - place.row;
  if (row >= Pack<Real>::rows) return {};
  for (std::size_t l = row; l < Pack<Real>::lanes; l += Pack<Real>::rows) {
    if ((packs.taken[i] & bit(l)) == 0) return Lane{i, l};
  }
  return {};
}

// A pack of the reserve, laid so that rows above and below the home cell find room in it later.
template <class Real>
std::optional<Lane> take_from_reserve(Packs<Real>& packs, const PackPlace& home) {
  constexpr std::uint32_t below = 3;
  PackGroup& group = packs.group[group_of(home.column)];
  if (group.in_use >= most_in_use(group.in_order)) return {};
  const std::size_t i = group.first + group.in_use++;
  packs.place[i] = {home.column, home.row - std::min(home.row, below)};
  return Lane{i, home.row - packs.place[i].row};
}

template <class Real>
std::optional<Lane> find_lane(Packs<Real>& packs, const PackPlace& home) {
  const PackGroup& group = packs.group[group_of(home.column)];
  const std::size_t in_order = group.first + group.in_order;
  for (std::size_t i = group.first + packs.column[home.column].first;
       i < in_order && packs.place[i].column == home.column; ++i) {
    if (const auto lane = free_lane(packs, i, home)) return lane;
  }
  for (std::size_t i = in_order; i < group.end(); ++i) {
    if (const auto lane = free_lane(packs, i, home)) return lane;
  }
  return take_from_reserve(packs, home);
}

template <class Real>
void make_anew(Packs<Real>& packs, Grid<Real>& grid, std::size_t g) {
  std::vector<PointAtHome<Real>> points;
  points.reserve(packs.group[g].points);
  for (std::size_t i = packs.group[g].first; i < packs.group[g].end(); ++i) {
    const PackPlace& place = packs.place[i];
    for (std::uint32_t l = 0; l < Pack<Real>::lanes; ++l) {
      if ((packs.taken[i] & bit(l)) == 0) continue;
      points.push_back(
          {{place.column, place.row + l % static_cast<std::uint32_t>(Pack<Real>::rows)},
           take_point(packs, i, l)});
    }
  }
  fill_group(packs, grid, g, points);
}

template <class Real>
void put_in(Packs<Real>& packs, Grid<Real>& grid, const PointAtHome<Real>& stray) {
  const std::size_t g = group_of(stray.home.column);
  auto to = find_lane(packs, stray.home);
  if (!to) {
    make_anew(packs, grid, g);
    to = take_from_reserve(packs, stray.home);
  }
  put_point(stray.point, packs, to->pack, to->lane);
  packs.taken[to->pack] = static_cast<LaneBits>(packs.taken[to->pack] | bit(to->lane));
  ++packs.group[g].points;
  raise_tops(packs, grid, stray.home);
}

}  // namespace

template <class Real>
bool rehome_strays(Packs<Real>& packs, Grid<Real>& grid) {
  const auto strays = find_strays(packs, grid);
  if (!strays) return false;
  std::vector<PointAtHome<Real>> points;
  points.reserve(strays->size());
  for (const Stray& stray : *strays) points.push_back(take_out(packs, stray));
  for (const PointAtHome<Real>& point : points) put_in(packs, grid, point);
  return true;
}

template bool rehome_strays(Packs<float>&, Grid<float>&);
template bool rehome_strays(Packs<double>&, Grid<double>&);

}  // namespace leda::solver
