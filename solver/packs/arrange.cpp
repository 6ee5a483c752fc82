#include "solver/packs/arrange.hpp"

#include <algorithm>
#include <cmath>

namespace leda::solver {

namespace {

constexpr std::uint32_t no_cell = 0xffffffff;

// A point of the old order for each lane of the new packs; -1 where there is none.
struct Arrangement {
  std::vector<PackPlace> place;
  std::vector<std::int32_t> source;
};

// Whether what a point in this home cell sees, and one cell more, lies on the grid. Written so
// that what is not a number fails too.
bool on_grid(const PackGrid& grid, double column, double row) {
  return column >= 0 && column + 3 <= static_cast<double>(grid.columns) && row >= 0 &&
         row + 4 <= static_cast<double>(grid.rows);
}

// First place of each cell's points in the order of cells; cell c has those up to start[c + 1].
std::vector<std::uint32_t> count_cells(const std::vector<std::uint32_t>& cell, std::size_t cells) {
  std::vector<std::uint32_t> start(cells + 1, 0);
  for (const std::uint32_t c : cell) {
    if (c != no_cell) ++start[c + 1];
  }
  for (std::size_t c = 1; c <= cells; ++c) start[c] += start[c - 1];
  return start;
}

std::vector<std::int32_t> order_by_cell(const std::vector<std::uint32_t>& cell,
                                        std::vector<std::uint32_t> start) {
  std::vector<std::int32_t> order(start.back());
  for (std::size_t i = 0; i < cell.size(); ++i) {
    if (cell[i] != no_cell) order[start[cell[i]]++] = static_cast<std::int32_t>(i);
  }
  return order;
}

// Column by column, a pack begins at the lowest row that has points left and takes one of each row
// it reaches: no other choice of packs of eight rows needs fewer.
Arrangement arrange(const std::vector<std::uint32_t>& cell, PackGrid& grid) {
  const auto start = count_cells(cell, grid.columns * grid.rows);
  const auto order = order_by_cell(cell, start);
  Arrangement a;
  a.source.reserve(order.size() * 2);
  std::vector<std::size_t> highest(grid.columns, 0);
  std::vector<std::uint32_t> taken(grid.rows + Pack::lanes);
  for (std::size_t c = 0; c < grid.columns; ++c) {
    const std::uint32_t* first = &start[c * grid.rows];
    std::copy(first, first + grid.rows, taken.begin());
    for (std::size_t k = 0; k < grid.rows; ++k) {
      if (first[k + 1] > first[k]) highest[c] = k + 1;
      while (taken[k] < first[k + 1]) {
        a.place.push_back({static_cast<std::uint32_t>(c), static_cast<std::uint32_t>(k)});
        for (std::size_t row = k; row < k + Pack::lanes; ++row) {
          const bool has = row < grid.rows && taken[row] < first[row + 1];
          a.source.push_back(has ? order[taken[row]++] : -1);
        }
      }
    }
  }
  // A point of column c sees columns c to c + 2; before the next time it may move one cell.
  for (std::size_t c = 0; c < grid.columns; ++c) {
    std::size_t top = 0;
    for (std::size_t from = c >= 3 ? c - 3 : 0; from <= std::min(c + 1, grid.columns - 1); ++from) {
      if (highest[from] > 0) top = std::max(top, highest[from] + 3);
    }
    grid.top[c] = std::min(top, grid.rows);
  }
  return a;
}

Pack empty_pack() {
  Pack p{};
  std::fill(std::begin(p.x), std::end(p.x), Real{0.5});
  std::fill(std::begin(p.z), std::end(p.z), Real{0.5});
  std::fill(std::begin(p.particle), std::end(p.particle), -1);
  return p;
}

// Lanes without a point take the law of the first point, so that one row serves the pack.
void share_law(Pack& p) {
  std::int32_t law = 0;
  for (std::size_t l = Pack::lanes; l-- > 0;) {
    if (p.particle[l] >= 0) law = p.law[l];
  }
  for (std::size_t l = 0; l < Pack::lanes; ++l) {
    if (p.particle[l] < 0) p.law[l] = law;
  }
}

// Builds the packs of an arrangement; take(source, pack, lane, number of the pack) copies a point.
template <class Take>
void fill(Packs& packs, const PackGrid& grid, Arrangement&& a, const Take& take) {
  packs.pack.assign(a.place.size(), empty_pack());
  packs.place = std::move(a.place);
  packs.motion.resize(packs.place.size());
  for (std::size_t i = 0; i < packs.pack.size(); ++i) {
    for (std::size_t l = 0; l < Pack::lanes; ++l) {
      const std::int32_t from = a.source[i * Pack::lanes + l];
      if (from >= 0) take(static_cast<std::size_t>(from), packs.pack[i], l, i);
    }
    share_law(packs.pack[i]);
  }
  find_groups(packs, grid);
}

}  // namespace

bool pack(const Particles& particles, PackGrid& grid, Packs& packs) {
  const double per_h = 1 / grid.h;
  const auto home = [&](double at) { return std::floor(at * per_h + 0.5); };
  std::vector<std::uint32_t> cell(particles.count);
  for (std::size_t i = 0; i < particles.count; ++i) {
    const double column = home(particles.x[i]), row = home(particles.z[i]);
    if (!on_grid(grid, column, row)) return false;
    cell[i] = static_cast<std::uint32_t>(column) * static_cast<std::uint32_t>(grid.rows) +
              static_cast<std::uint32_t>(row);
  }
  packs.count = particles.count;
  fill(packs, grid, arrange(cell, grid),
       [&](std::size_t from, Pack& p, std::size_t l, std::size_t i) {
         const auto within = [&](double at) {
           // Rounding to single precision must not carry a point over the edge of its cell.
           const Real part = static_cast<Real>(at * per_h + 0.5 - home(at));
           return std::min(part, std::nextafter(Real{1}, Real{0}));
         };
         const auto real = [](double value) { return static_cast<Real>(value); };
         p.x[l] = within(particles.x[from]);
         p.z[l] = within(particles.z[from]);
         p.sxx[l] = real(particles.sxx[from]);
         p.szz[l] = real(particles.szz[from]);
         p.sxz[l] = real(particles.sxz[from]);
         p.syy[l] = real(particles.syy[from]);
         p.mass[l] = real(particles.mass[from]);
         p.volume[l] = real(particles.volume[from]);
         p.plastic_strain[l] = real(particles.plastic_strain[from]);
         p.law[l] = particles.law[from];
         p.particle[l] = static_cast<std::int32_t>(from);
         PackMotion& m = packs.motion[i];
         m.vx[l] = real(particles.vx[from]);
         m.vz[l] = real(particles.vz[from]);
         m.cxx[l] = real(particles.cxx[from] * grid.h);
         m.cxz[l] = real(particles.cxz[from] * grid.h);
         m.czx[l] = real(particles.czx[from] * grid.h);
         m.czz[l] = real(particles.czz[from] * grid.h);
       });
  return true;
}

bool rearrange(Packs& packs, PackGrid& grid) {
  std::vector<std::uint32_t> cell(packs.pack.size() * Pack::lanes, no_cell);
  for (std::size_t i = 0; i < packs.pack.size(); ++i) {
    const Pack& p = packs.pack[i];
    const auto column = static_cast<double>(packs.place[i].column);
    const auto row = static_cast<double>(packs.place[i].row);
    for (std::size_t l = 0; l < Pack::lanes; ++l) {
      if (p.particle[l] < 0) continue;
      const double c = column + std::floor(p.x[l]);
      const double r = row + static_cast<double>(l) + std::floor(p.z[l]);
      if (!on_grid(grid, c, r)) return false;
      cell[i * Pack::lanes + l] =
          static_cast<std::uint32_t>(c) * static_cast<std::uint32_t>(grid.rows) +
          static_cast<std::uint32_t>(r);
    }
  }
  Packs old;
  old.pack.swap(packs.pack);
  fill(packs, grid, arrange(cell, grid),
       [&](std::size_t from, Pack& p, std::size_t l, std::size_t) {
         const Pack& q = old.pack[from / Pack::lanes];
         const std::size_t s = from % Pack::lanes;
         p.x[l] = q.x[s] - std::floor(q.x[s]);
         p.z[l] = q.z[s] - std::floor(q.z[s]);
         p.sxx[l] = q.sxx[s];
         p.szz[l] = q.szz[s];
         p.sxz[l] = q.sxz[s];
         p.syy[l] = q.syy[s];
         p.mass[l] = q.mass[s];
         p.volume[l] = q.volume[s];
         p.plastic_strain[l] = q.plastic_strain[s];
         p.plastic_rest[l] = q.plastic_rest[s];
         p.law[l] = q.law[s];
         p.particle[l] = q.particle[s];
       });
  return true;
}

void find_groups(Packs& packs, const PackGrid& grid) {
  const std::size_t groups = groups_of(grid);
  packs.group.assign(groups + 1, packs.place.size());
  packs.group_points.assign(groups, 0);
  for (std::size_t i = packs.place.size(); i-- > 0;) {
    const std::size_t g = packs.place[i].column / columns_of_a_group;
    packs.group[g] = i;
    for (const std::int32_t particle : packs.pack[i].particle) {
      if (particle >= 0) ++packs.group_points[g];
    }
  }
  for (std::size_t g = groups; g-- > 0;) {
    packs.group[g] = std::min(packs.group[g], packs.group[g + 1]);
  }
}

void unpack_positions(const Packs& packs, const PackGrid& grid, Particles& particles) {
  for (std::size_t i = 0; i < packs.pack.size(); ++i) {
    const Pack& p = packs.pack[i];
    const double column = packs.place[i].column - 0.5, row = packs.place[i].row - 0.5;
    for (std::size_t l = 0; l < Pack::lanes; ++l) {
      if (p.particle[l] < 0) continue;
      const auto to = static_cast<std::size_t>(p.particle[l]);
      particles.x[to] = (column + static_cast<double>(p.x[l])) * grid.h;
      particles.z[to] = (row + static_cast<double>(l) + static_cast<double>(p.z[l])) * grid.h;
    }
  }
}

void unpack(const Packs& packs, const PackGrid& grid, Particles& particles) {
  const double per_h = 1 / grid.h;
  unpack_positions(packs, grid, particles);
  for (std::size_t i = 0; i < packs.pack.size(); ++i) {
    const Pack& p = packs.pack[i];
    const PackMotion& m = packs.motion[i];
    for (std::size_t l = 0; l < Pack::lanes; ++l) {
      if (p.particle[l] < 0) continue;
      const auto to = static_cast<std::size_t>(p.particle[l]);
      particles.sxx[to] = p.sxx[l];
      particles.szz[to] = p.szz[l];
      particles.sxz[to] = p.sxz[l];
      particles.syy[to] = p.syy[l];
      particles.volume[to] = p.volume[l];
      particles.plastic_strain[to] = p.plastic_strain[l];
      particles.vx[to] = m.vx[l];
      particles.vz[to] = m.vz[l];
      particles.cxx[to] = m.cxx[l] * per_h;
      particles.cxz[to] = m.cxz[l] * per_h;
      particles.czx[to] = m.czx[l] * per_h;
      particles.czz[to] = m.czz[l] * per_h;
    }
  }
  particles.fill_padding();
}

}  // namespace leda::solver
