#include "solver/kernel/group.hpp"

#include <algorithm>

namespace leda::solver {

namespace {

// A point of the list for each lane of the new packs; -1 where there is none.
struct Arrangement {
  std::vector<PackPlace> place;
  std::vector<std::int32_t> source;
};

// Rows above a point's home that it sees, and one to spare.
constexpr std::size_t rows_above = 4;

std::size_t first_column(std::size_t g) { return g * columns_of_a_group; }

template <class Real>
std::size_t end_column(const Grid<Real>& grid, std::size_t g) {
  return std::min(first_column(g + 1), grid.columns);
}

// Points by cell: those of cell c, column by column from the group's first, stand in `order` from
// start[c] to start[c + 1].
struct CellOrder {
  std::vector<std::uint32_t> start;
  std::vector<std::int32_t> order;
};

template <class Real>
CellOrder order_by_cell(const Grid<Real>& grid, std::size_t g,
                        const std::vector<PointAtHome<Real>>& points) {
  const std::size_t cells = (end_column(grid, g) - first_column(g)) * grid.rows;
  const auto cell = [&](const PackPlace& home) {
    return (home.column - first_column(g)) * grid.rows + home.row;
  };
  CellOrder o;
  o.start.assign(cells + 2, 0);
  for (const PointAtHome<Real>& p : points) ++o.start[cell(p.home) + 2];
  for (std::size_t c = 2; c < o.start.size(); ++c) o.start[c] += o.start[c - 1];
  o.order.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    o.order[o.start[cell(points[i].home) + 1]++] = static_cast<std::int32_t>(i);
  }
  return o;
}

// Column by column, a pack begins at the lowest row that has points left and takes two of each row
// it reaches: no other choice of packs of eight rows needs fewer.
template <class Real>
Arrangement arrange(Packs<Real>& packs, const Grid<Real>& grid, std::size_t g,
                    const std::vector<PointAtHome<Real>>& points) {
  const CellOrder o = order_by_cell(grid, g, points);
  Arrangement a;
  a.source.reserve(points.size() * 2);
  std::vector<std::uint32_t> taken(grid.rows + Pack<Real>::rows);
  for (std::size_t c = first_column(g); c < end_column(grid, g); ++c) {
    PackColumn& column = packs.column[c];
    column = {static_cast<std::uint32_t>(a.place.size()), 0};
    const std::uint32_t* first = &o.start[(c - first_column(g)) * grid.rows];
    if (first[grid.rows] == first[0]) continue;
    std::copy(first, first + grid.rows, taken.begin());
    for (std::size_t k = 0; k < grid.rows; ++k) {
      if (first[k + 1] > first[k]) column.rows = static_cast<std::uint32_t>(k + 1);
      while (taken[k] < first[k + 1]) {
        a.place.push_back({static_cast<std::uint32_t>(c), static_cast<std::uint32_t>(k)});
        for (std::size_t l = 0; l < Pack<Real>::lanes; ++l) {
          const std::size_t row = k + l % Pack<Real>::rows;
          const bool has = row < grid.rows && taken[row] < first[row + 1];
          a.source.push_back(has ? o.order[taken[row]++] : -1);
        }
      }
    }
  }
  return a;
}

template <class Real>
void clear_pack(Packs<Real>& packs, std::size_t i) {
  for (std::size_t l = 0; l < Pack<Real>::lanes; ++l) put_point(no_point<Real>(0), packs, i, l);
  packs.taken[i] = packs.strayed[i] = 0;
}

// Lanes without a point take the law of the first point, so that one row serves the pack.
template <class Real>
std::int32_t law_of_pack(const std::int32_t* source, const std::vector<PointAtHome<Real>>& points) {
  const auto* first =
      std::find_if(source, source + Pack<Real>::lanes, [](std::int32_t i) { return i >= 0; });
  return points[static_cast<std::size_t>(*first)].point.law;
}

template <class Real>
void fill_pack(Packs<Real>& packs, std::size_t i, const std::int32_t* source,
               const std::vector<PointAtHome<Real>>& points) {
  const PackedPoint<Real> none = no_point<Real>(law_of_pack(source, points));
  LaneBits taken = 0;
  for (std::size_t l = 0; l < Pack<Real>::lanes; ++l) {
    const bool has = source[l] >= 0;
    put_point(has ? points[static_cast<std::size_t>(source[l])].point : none, packs, i, l);
    if (has) taken = static_cast<LaneBits>(taken | 1U << l);
  }
  packs.taken[i] = taken;
  packs.strayed[i] = 0;
}

// A point of column c sees columns c to c + 2; before the next time it may move one cell.
template <class Real>
void set_top(const Packs<Real>& packs, Grid<Real>& grid, std::size_t c) {
  std::size_t top = 0;
  for (std::size_t from = c >= 3 ? c - 3 : 0; from <= std::min(c + 1, grid.columns - 1); ++from) {
    if (packs.column[from].rows > 0) top = std::max(top, packs.column[from].rows + rows_above - 1);
  }
  grid.top[c] = std::min(top, grid.rows);
}

template <class Real>
void set_tops(const Packs<Real>& packs, Grid<Real>& grid, std::size_t first, std::size_t end) {
  for (std::size_t c = first > 0 ? first - 1 : 0; c < std::min(end + 3, grid.columns); ++c) {
    set_top(packs, grid, c);
  }
}

}  // namespace

template <class Real>
void begin_groups(Packs<Real>& packs, const Grid<Real>& grid) {
  const bool held = packs.held, moves = packs.moves;
  packs = Packs<Real>{};
  packs.held = held;
  packs.moves = moves;
  packs.group.resize(groups_of(grid.columns));
  packs.column.resize(grid.columns);
}

template <class Real>
void make_room(Packs<Real>& packs, std::size_t g, std::size_t room) {
  PackGroup& group = packs.group[g];
  if (room <= group.room) return;
  const std::size_t more = room - group.room;
  const auto end = static_cast<std::ptrdiff_t>(group.first + group.room);
  packs.pack.insert(packs.pack.begin() + end, more, Pack<Real>{});
  packs.place.insert(packs.place.begin() + end, more, PackPlace{});
  if (packs.moves) packs.motion.insert(packs.motion.begin() + end, more, PackMotion<Real>{});
  packs.taken.insert(packs.taken.begin() + end, more, 0);
  packs.strayed.insert(packs.strayed.begin() + end, more, 0);
  for (std::size_t i = group.first + group.room; i < group.first + room; ++i) clear_pack(packs, i);
  group.room = room;
  for (std::size_t later = g + 1; later < packs.group.size(); ++later) {
    packs.group[later].first += more;
  }
}

template <class Real>
void set_all_tops(const Packs<Real>& packs, Grid<Real>& grid) {
  set_tops(packs, grid, 0, grid.columns);
}

template <class Real>
void fill_group(Packs<Real>& packs, Grid<Real>& grid, std::size_t g,
                const std::vector<PointAtHome<Real>>& points) {
  const Arrangement a = arrange(packs, grid, g, points);
  const std::size_t count = a.place.size();
  make_room(packs, g, packs.held ? count : most_in_use(count));
  PackGroup& group = packs.group[g];
  for (std::size_t i = count; i < group.in_use; ++i) clear_pack(packs, group.first + i);
  for (std::size_t i = 0; i < count; ++i) {
    packs.place[group.first + i] = a.place[i];
    fill_pack(packs, group.first + i, &a.source[i * Pack<Real>::lanes], points);
  }
  group.in_order = group.in_use = count;
  group.points = points.size();
  set_tops(packs, grid, first_column(g), end_column(grid, g));
}

template <class Real>
void raise_tops(Packs<Real>& packs, Grid<Real>& grid, const PackPlace& home) {
  std::uint32_t& rows = packs.column[home.column].rows;
  if (home.row < rows) return;
  rows = home.row + 1;
  set_tops(packs, grid, home.column, home.column + 1);
}

#define LEDA_INSTANCES(Real)                                       \
  template void begin_groups(Packs<Real>&, const Grid<Real>&);     \
  template void make_room(Packs<Real>&, std::size_t, std::size_t); \
  template void set_all_tops(const Packs<Real>&, Grid<Real>&);     \
  template void fill_group(Packs<Real>&, Grid<Real>&, std::size_t, \
                           const std::vector<PointAtHome<Real>>&); \
  template void raise_tops(Packs<Real>&, Grid<Real>&, const PackPlace&);
LEDA_INSTANCES(float)
LEDA_INSTANCES(double)
#undef LEDA_INSTANCES

}  // namespace leda::solver
