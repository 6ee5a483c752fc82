#include "solver/kernel/pack.hpp"

#include <algorithm>
#include <cmath>

#include "solver/kernel/pack_group.hpp"

namespace leda::solver {

namespace {

// Rounding to single precision must not carry a point over the edge of its cell.
Real within_cell(double part) {
  return std::min(static_cast<Real>(part), std::nextafter(Real{1}, Real{0}));
}

PackedPoint packed_point(const Particles& p, std::size_t i, Real x, Real z) {
  const auto real = [](double value) { return static_cast<Real>(value); };
  return {x,
          z,
          real(p.sxx[i]),
          real(p.szz[i]),
          real(p.sxz[i]),
          real(p.syy[i]),
          real(p.mass[i]),
          real(p.volume[i]),
          real(p.plastic_strain[i]),
          0,
          p.law[i],
          static_cast<std::int32_t>(i)};
}

void take_motion(const Particles& p, Real h, Packs& packs) {
  const auto real = [](double value) { return static_cast<Real>(value); };
  for (std::size_t i = 0; i < packs.pack.size(); ++i) {
    PackMotion& m = packs.motion[i];
    for (std::size_t l = 0; l < Pack::lanes; ++l) {
      if (packs.pack[i].particle[l] < 0) continue;
      const auto from = static_cast<std::size_t>(packs.pack[i].particle[l]);
      m.vx[l] = real(p.vx[from]);
      m.vz[l] = real(p.vz[from]);
      m.cxx[l] = real(p.cxx[from]) * h;
      m.cxz[l] = real(p.cxz[from]) * h;
      m.czx[l] = real(p.czx[from]) * h;
      m.czz[l] = real(p.czz[from]) * h;
    }
  }
}

}  // namespace

bool on_grid(const PackGrid& grid, double column, double row) {
  return column >= 0 && column + 3 <= static_cast<double>(grid.columns) && row >= 0 &&
         row + 4 <= static_cast<double>(grid.rows);
}

bool pack(const Particles& particles, PackGrid& grid, Packs& packs) {
  const double per_h = 1 / grid.h;
  const auto home = [&](double at) { return std::floor(at * per_h + 0.5); };
  std::vector<std::vector<PointAtHome>> points(groups_of(grid));
  for (std::size_t i = 0; i < particles.count; ++i) {
    const double column = home(particles.x[i]), row = home(particles.z[i]);
    if (!on_grid(grid, column, row)) return false;
    const PackPlace place{static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row)};
    points[place.column / columns_of_a_group].push_back(
        {place, packed_point(particles, i, within_cell(particles.x[i] * per_h + 0.5 - column),
                             within_cell(particles.z[i] * per_h + 0.5 - row))});
  }
  begin_groups(packs, grid);
  packs.count = particles.count;
  for (std::size_t g = 0; g < points.size(); ++g) fill_group(packs, grid, g, points[g]);
  take_motion(particles, static_cast<Real>(grid.h), packs);
  return true;
}

void unpack(const Packs& packs, const PackGrid& grid, Particles& particles) {
  const double per_h = 1 / grid.h;
  for (std::size_t i = 0; i < packs.pack.size(); ++i) {
    const Pack& p = packs.pack[i];
    const PackMotion& m = packs.motion[i];
    const double column = packs.place[i].column - 0.5, row = packs.place[i].row - 0.5;
    for (std::size_t l = 0; l < Pack::lanes; ++l) {
      if (p.particle[l] < 0) continue;
      const auto to = static_cast<std::size_t>(p.particle[l]);
      particles.x[to] = (column + static_cast<double>(p.x[l])) * grid.h;
      particles.z[to] =
          (row + static_cast<double>(l % Pack::rows) + static_cast<double>(p.z[l])) * grid.h;
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
