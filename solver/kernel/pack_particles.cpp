#include "solver/kernel/pack_particles.hpp"

#include <algorithm>
#include <cmath>

#include "solver/kernel/group.hpp"

namespace leda::solver {

namespace {

// Rounding to the number type must not carry a point over the edge of its cell.
template <class Real>
Real within_cell(double part) {
  return std::min(static_cast<Real>(part), std::nextafter(Real{1}, Real{0}));
}

struct Home {
  double column, row;
};

Home home_of(const Particle& p, double h) {
  return {std::floor(p.x / h + 0.5), std::floor(p.z / h + 0.5)};
}

template <class Real>
PackedPoint<Real> packed_point(const Particle& p, double h) {
  PackedPoint<Real> to;
  for (std::size_t n = 0; n < to.number.size(); ++n) {
    const auto value = point_numbers<Real>[n].value;
    to.number[n] = value == nullptr ? Real{0} : static_cast<Real>(p.*value);
  }
  for (std::size_t n = 0; n < to.motion.size(); ++n) {
    const auto& number = motion_numbers<Real>[n];
    to.motion[n] =
        static_cast<Real>(p.*number.value) * (number.per_cell ? static_cast<Real>(h) : Real{1});
  }
  to.law = p.law;
  to.id = p.id;
  return to;
}

template <class Real>
PointAtHome<Real> at_home(const Particle& p, double h) {
  const Home home = home_of(p, h);
  PackedPoint<Real> point = packed_point<Real>(p, h);
  point.number[0] = within_cell<Real>(p.x / h + 0.5 - home.column);
  point.number[1] = within_cell<Real>(p.z / h + 0.5 - home.row);
  return {{static_cast<std::uint32_t>(home.column), static_cast<std::uint32_t>(home.row)}, point};
}

}  // namespace

template <class Real>
bool on_grid(const Grid<Real>& grid, double column, double row) {
  return column >= 0 && column + 3 <= static_cast<double>(grid.columns) && row >= 0 &&
         row + 4 <= static_cast<double>(grid.rows);
}

template <class Real>
bool pack(const Particles& particles, Grid<Real>& grid, Packs<Real>& packs) {
  std::vector<std::vector<std::uint32_t>> of_group(groups_of(grid.columns));
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Home home = home_of(particles[i], grid.h);
    if (!on_grid(grid, home.column, home.row)) return false;
    const std::size_t g = static_cast<std::size_t>(home.column) / columns_of_a_group;
    of_group[g].push_back(static_cast<std::uint32_t>(i));
  }
  begin_groups(packs, grid);
  packs.count = particles.size();
  // Packs hold 13 points of ground that has not flowed; growing as needed would take twice the
  // room.
  const std::size_t likely = particles.size() / 13 * (packs.held ? 21 : 25) / 20;
  packs.pack.reserve(likely);
  if (packs.moves) packs.motion.reserve(likely);
  std::vector<PointAtHome<Real>> points;
  for (std::size_t g = 0; g < of_group.size(); ++g) {
    points.clear();
    for (const std::uint32_t i : of_group[g]) points.push_back(at_home<Real>(particles[i], grid.h));
    fill_group(packs, grid, g, points);
  }
  return true;
}

template <class Real>
Particles unpack(const Packs<Real>& packs, double h) {
  Particles particles;
  particles.reserve(packs.count);
  for_each_point(packs, [&](std::size_t i, std::size_t l) {
    Particle p;
    for (const auto& number : point_numbers<Real>) {
      if (number.value != nullptr) p.*number.value = (packs.pack[i].*number.lane)[l];
    }
    for (const auto& number : motion_numbers<Real>) {
      if (!packs.moves) break;
      const double value = (packs.motion[i].*number.lane)[l];
      p.*number.value = number.per_cell ? value / h : value;
    }
    const PointAt at = point_at(packs, i, l, h);
    p.x = at.x;
    p.z = at.z;
    p.law = packs.pack[i].law[l];
    p.id = packs.pack[i].id[l];
    particles.push_back(p);
  });
  std::ranges::sort(particles, {}, &Particle::id);
  return particles;
}

#define LEDA_INSTANCES(Real)                                       \
  template bool on_grid(const Grid<Real>&, double, double);        \
  template bool pack(const Particles&, Grid<Real>&, Packs<Real>&); \
  template Particles unpack(const Packs<Real>&, double);
LEDA_INSTANCES(float)
LEDA_INSTANCES(double)
#undef LEDA_INSTANCES

}  // namespace leda::solver
