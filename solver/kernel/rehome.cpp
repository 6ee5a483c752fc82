#include "solver/kernel/rehome.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "solver/kernel/pack.hpp"
#include "solver/kernel/pack_group.hpp"

namespace leda::solver {

namespace {

struct Stray {
  std::size_t pack, lane;
  PackPlace home;
};

std::size_t group_of(std::uint32_t column) { return column / columns_of_a_group; }

LaneBits bit(std::size_t lane) { return static_cast<LaneBits>(1U << lane); }

// The strays of a pack; false where one of them has left the grid.
bool find_strays(const Packs& packs, const PackGrid& grid, std::size_t i,
                 std::vector<Stray>& strays) {
  const Pack& p = packs.pack[i];
  const PackPlace& place = packs.place[i];
  for (LaneBits left = packs.strayed[i]; left != 0;
       left = static_cast<LaneBits>(left & (left - 1))) {
    const auto l = static_cast<std::size_t>(std::countr_zero(left));
    const double right = std::floor(static_cast<double>(p.x[l]));
    const double up = std::floor(static_cast<double>(p.z[l]));
    const double column = place.column + right,
                 row = place.row + static_cast<double>(l % Pack::rows) + up;
    if (!on_grid(grid, column, row)) return false;
    strays.push_back({i, l, {static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row)}});
  }
  return true;
}

std::optional<std::vector<Stray>> find_strays(const Packs& packs, const PackGrid& grid) {
  std::vector<Stray> strays;
  for (std::size_t i = 0; i < packs.strayed.size(); ++i) {
    if (packs.strayed[i] != 0 && !find_strays(packs, grid, i, strays)) return {};
  }
  return strays;
}

PointAtHome take_out(Packs& packs, const Stray& stray) {
  Pack& p = packs.pack[stray.pack];
  PackedPoint point = point_at(p, stray.lane);
  point.x -= std::floor(point.x);
  point.z -= std::floor(point.z);
  put_point(no_point(point.law), p, stray.lane);
  packs.strayed[stray.pack] = 0;
  packs.taken[stray.pack] = static_cast<LaneBits>(packs.taken[stray.pack] & ~bit(stray.lane));
  --packs.group[group_of(packs.place[stray.pack].column)].points;
  return {stray.home, point};
}

struct Lane {
  std::size_t pack, lane;
};

// A lane of pack i for a point of this home.
std::optional<Lane> free_lane(const Packs& packs, std::size_t i, const PackPlace& home) {
  const PackPlace& place = packs.place[i];
  if (place.column != home.column || home.row < place.row) return {};
  const std::size_t row = home.row - place.row;
  if (row >= Pack::rows) return {};
  for (std::size_t l = row; l < Pack::lanes; l += Pack::rows) {
    if ((packs.taken[i] & bit(l)) == 0) return Lane{i, l};
  }
  return {};
}

// A pack of the reserve, laid so that rows above and below the home cell find room in it later.
std::optional<Lane> take_from_reserve(Packs& packs, const PackPlace& home) {
  constexpr std::uint32_t below = 3;
  PackGroup& group = packs.group[group_of(home.column)];
  if (group.in_use >= most_in_use(group.in_order)) return {};
  const std::size_t i = group.first + group.in_use++;
  packs.place[i] = {home.column, home.row - std::min(home.row, below)};
  return Lane{i, home.row - packs.place[i].row};
}

std::optional<Lane> find_lane(Packs& packs, const PackPlace& home) {
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

void make_anew(Packs& packs, PackGrid& grid, std::size_t g) {
  std::vector<PointAtHome> points;
  points.reserve(packs.group[g].points);
  for (std::size_t i = packs.group[g].first; i < packs.group[g].end(); ++i) {
    const PackPlace& place = packs.place[i];
    for (std::uint32_t l = 0; l < Pack::lanes; ++l) {
      if ((packs.taken[i] & bit(l)) == 0) continue;
      points.push_back(
          {{place.column, place.row + l % std::uint32_t{Pack::rows}}, point_at(packs.pack[i], l)});
    }
  }
  fill_group(packs, grid, g, points);
}

void put_in(Packs& packs, PackGrid& grid, const PointAtHome& stray) {
  const std::size_t g = group_of(stray.home.column);
  auto to = find_lane(packs, stray.home);
  if (!to) {
    make_anew(packs, grid, g);
    to = take_from_reserve(packs, stray.home);
  }
  put_point(stray.point, packs.pack[to->pack], to->lane);
  packs.taken[to->pack] = static_cast<LaneBits>(packs.taken[to->pack] | bit(to->lane));
  PackMotion& m = packs.motion[to->pack];
  for (Real* value : {m.vx, m.vz, m.cxx, m.cxz, m.czx, m.czz}) value[to->lane] = 0;
  ++packs.group[g].points;
  raise_tops(packs, grid, stray.home);
}

}  // namespace

bool rehome_strays(Packs& packs, PackGrid& grid) {
  const auto strays = find_strays(packs, grid);
  if (!strays) return false;
  std::vector<PointAtHome> points;
  points.reserve(strays->size());
  for (const Stray& stray : *strays) points.push_back(take_out(packs, stray));
  for (const PointAtHome& point : points) put_in(packs, grid, point);
  return true;
}

}  // namespace leda::solver
