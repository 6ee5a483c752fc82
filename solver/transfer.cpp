#include "solver/transfer.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solver/transfer.cpp"
#include "hwy/foreach_target.h"
//
#include "hwy/highway.h"
#include "solver/materials/tresca-inl.hpp"
#include "solver/spline-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t block = 64;  // particles whose scratch stays in the first-level cache

// Values a node takes from a particle: mass, momentum x z, force x z. A row of three nodes of one
// column is 15 of them side by side; the 16th place stays zero.
struct P2gScratch {
  HWY_ALIGN double plain[block][16];   // share of a column's nodes, to be weighed by wx
  HWY_ALIGN double sloped[block][16];  // momentum: weighed by wx (x_i - x_p); force: by dwx/dx
  HWY_ALIGN double wx[block][4];
  HWY_ALIGN double wxdx[block][4];
  HWY_ALIGN double slope[block][4];
  HWY_ALIGN std::int64_t node[block];  // lowest node of the first column
};

template <class D>
HWY_INLINE void store_columns(D d, const ParticleSpline<D>& at, double* wx, double* wxdx,
                              double* slope) {
  const auto lane4 = hn::ShiftLeft<2>(hn::Iota(hn::RebindToSigned<D>(), 0));
  for (int j = 0; j < 3; ++j) {
    hn::ScatterIndex(at.wx[j], d, wx + j, lane4);
    hn::ScatterIndex(hn::Mul(at.wx[j], at.dx[j]), d, wxdx + j, lane4);
    hn::ScatterIndex(at.slope_x[j], d, slope + j, lane4);
  }
}

// What the particles i .. i+N of a block give to the nodes of their three columns.
template <class D>
HWY_INLINE void spread(D d, const Particles& p, std::size_t i, std::size_t slot, const Grid& grid,
                       P2gScratch& s) {
  const auto at = particle_spline(d, &p.x[i], &p.z[i], grid.h, grid.rows);
  hn::Store(at.node, hn::RebindToSigned<D>(), &s.node[slot]);
  store_columns(d, at, s.wx[slot], s.wxdx[slot], s.slope[slot]);
  const auto mass = hn::LoadU(d, &p.mass[i]);
  const auto volume = hn::Neg(hn::LoadU(d, &p.volume[i]));
  const auto px = hn::Mul(mass, hn::LoadU(d, &p.vx[i]));
  const auto pz = hn::Mul(mass, hn::LoadU(d, &p.vz[i]));
  const auto pxx = hn::Mul(mass, hn::LoadU(d, &p.cxx[i]));
  const auto pxz = hn::Mul(mass, hn::LoadU(d, &p.cxz[i]));
  const auto pzx = hn::Mul(mass, hn::LoadU(d, &p.czx[i]));
  const auto pzz = hn::Mul(mass, hn::LoadU(d, &p.czz[i]));
  const auto fxx = hn::Mul(volume, hn::LoadU(d, &p.sxx[i]));
  const auto fxz = hn::Mul(volume, hn::LoadU(d, &p.sxz[i]));
  const auto fzz = hn::Mul(volume, hn::LoadU(d, &p.szz[i]));
  const auto lane16 = hn::ShiftLeft<4>(hn::Iota(hn::RebindToSigned<D>(), 0));
  for (int j = 0; j < 3; ++j) {
    const auto wz = at.wz[j], dz = at.dz[j], slope = at.slope_z[j];
    double* plain = s.plain[slot] + j * 5;
    double* sloped = s.sloped[slot] + j * 5;
    hn::ScatterIndex(hn::Mul(wz, mass), d, plain, lane16);
    hn::ScatterIndex(hn::Mul(wz, hn::MulAdd(dz, pxz, px)), d, plain + 1, lane16);
    hn::ScatterIndex(hn::Mul(wz, hn::MulAdd(dz, pzz, pz)), d, plain + 2, lane16);
    hn::ScatterIndex(hn::Mul(slope, fxz), d, plain + 3, lane16);
    hn::ScatterIndex(hn::Mul(slope, fzz), d, plain + 4, lane16);
    hn::ScatterIndex(hn::Mul(wz, pxx), d, sloped + 1, lane16);
    hn::ScatterIndex(hn::Mul(wz, pzx), d, sloped + 2, lane16);
    hn::ScatterIndex(hn::Mul(wz, fxx), d, sloped + 3, lane16);
    hn::ScatterIndex(hn::Mul(wz, fxz), d, sloped + 4, lane16);
  }
}

// 1 where a place of the row of 16 is a force, 0 elsewhere.
HWY_ALIGN constexpr double force_places[16] = {0, 0, 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 1, 0};

void ParticlesToGrid(const Particles& p, Grid& grid) {
  const hn::CappedTag<double, 8> d;
  constexpr std::size_t n = hn::MaxLanes(hn::CappedTag<double, 8>());
  constexpr std::size_t parts = 16 / n;
  P2gScratch s;
  std::fill(&s.plain[0][0], &s.plain[0][0] + block * 16, 0.0);
  std::fill(&s.sloped[0][0], &s.sloped[0][0] + block * 16, 0.0);
  using V = hn::Vec<decltype(d)>;
  V sum[3][parts];  // one cell's nodes, kept in registers while the cell stays the same
  const auto zero = [&] {
    for (auto& column : sum)
      for (auto& part : column) part = hn::Zero(d);
  };
  const auto flush = [&](std::int64_t node) {
    for (std::size_t i = 0; i < 3; ++i) {
      double* to = &grid.node[(static_cast<std::size_t>(node) + i * grid.rows) * Grid::width];
      for (std::size_t l = 0; l < parts; ++l) {
        hn::StoreU(hn::Add(hn::LoadU(d, to + l * n), sum[i][l]), d, to + l * n);
      }
    }
  };
  zero();
  std::int64_t cell = -1;
  for (std::size_t first = 0; first < p.count; first += block) {
    const std::size_t padded = std::min(block, p.padded() - first);
    for (std::size_t i = 0; i < padded; i += n) spread(d, p, first + i, i, grid, s);
    const std::size_t count = std::min(block, p.count - first);
    for (std::size_t i = 0; i < count; ++i) {
      if (s.node[i] != cell) {
        if (cell >= 0) flush(cell);
        zero();
        cell = s.node[i];
      }
      for (std::size_t c = 0; c < 3; ++c) {
        const auto wx = hn::Set(d, s.wx[i][c]);
        const auto wxdx = hn::Set(d, s.wxdx[i][c]);
        const auto slope = hn::Set(d, s.slope[i][c]);
        for (std::size_t l = 0; l < parts; ++l) {
          const auto is_force = hn::Ne(hn::Load(d, force_places + l * n), hn::Zero(d));
          const auto weight = hn::IfThenElse(is_force, slope, wxdx);
          const auto part = hn::MulAdd(wx, hn::Load(d, &s.plain[i][l * n]), sum[c][l]);
          sum[c][l] = hn::MulAdd(weight, hn::Load(d, &s.sloped[i][l * n]), part);
        }
      }
    }
  }
  if (cell >= 0) flush(cell);
}

// Sums over the three columns, for three nodes of a column and two axes (6 of 8 places).
struct G2pScratch {
  HWY_ALIGN double plain[block][8];   // of wx v
  HWY_ALIGN double moment[block][8];  // of wx (x_i - x_p) v
  HWY_ALIGN double sloped[block][8];  // of dwx/dx v
  HWY_ALIGN double wx[block][4];
  HWY_ALIGN double wxdx[block][4];
  HWY_ALIGN double slope[block][4];
  HWY_ALIGN std::int64_t node[block];
};

template <class D>
HWY_INLINE void weigh(D d, const Particles& p, std::size_t i, std::size_t slot, const Grid& grid,
                      G2pScratch& s) {
  const auto at = particle_spline(d, &p.x[i], &p.z[i], grid.h, grid.rows);
  hn::Store(at.node, hn::RebindToSigned<D>(), &s.node[slot]);
  store_columns(d, at, s.wx[slot], s.wxdx[slot], s.slope[slot]);
}

HWY_INLINE void gather_columns(const Grid& grid, std::size_t i, G2pScratch& s) {
  const hn::CappedTag<double, 8> d;
  constexpr std::size_t n = hn::MaxLanes(hn::CappedTag<double, 8>());
  const double* from = &grid.velocity[static_cast<std::size_t>(s.node[i]) * 2];
  for (std::size_t l = 0; l < 8; l += n) {
    auto plain = hn::Zero(d), moment = plain, sloped = plain;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto v = hn::LoadU(d, from + c * grid.rows * 2 + l);
      plain = hn::MulAdd(hn::Set(d, s.wx[i][c]), v, plain);
      moment = hn::MulAdd(hn::Set(d, s.wxdx[i][c]), v, moment);
      sloped = hn::MulAdd(hn::Set(d, s.slope[i][c]), v, sloped);
    }
    hn::Store(plain, d, &s.plain[i][l]);
    hn::Store(moment, d, &s.moment[i][l]);
    hn::Store(sloped, d, &s.sloped[i][l]);
  }
}

// Velocity, its APIC moment matrix and its gradient at a vector of particles.
template <class D>
struct Motion {
  hn::Vec<D> vx, vz;
  hn::Vec<D> cxx, cxz, czx, czz;  // 4 / h^2 sum w v (x_i - x_p), 1/s
  hn::Vec<D> lxx, lxz, lzx, lzz;  // sum v grad w, 1/s
};

template <class D>
HWY_INLINE Motion<D> motion_at(D d, const ParticleSpline<D>& at, std::size_t slot,
                               const G2pScratch& s, double h) {
  const auto lane8 = hn::ShiftLeft<3>(hn::Iota(hn::RebindToSigned<D>(), 0));
  const auto zero = hn::Zero(d);
  Motion<D> m{zero, zero, zero, zero, zero, zero, zero, zero, zero, zero};
  for (int j = 0; j < 3; ++j) {
    const auto wz = at.wz[j], dz = at.dz[j], slope = at.slope_z[j];
    const auto x = hn::GatherIndex(d, s.plain[slot] + j * 2, lane8);
    const auto z = hn::GatherIndex(d, s.plain[slot] + j * 2 + 1, lane8);
    const auto wx = hn::Mul(wz, x), wzz = hn::Mul(wz, z);
    m.vx = hn::Add(m.vx, wx);
    m.vz = hn::Add(m.vz, wzz);
    m.cxz = hn::MulAdd(wx, dz, m.cxz);
    m.czz = hn::MulAdd(wzz, dz, m.czz);
    m.lxz = hn::MulAdd(slope, x, m.lxz);
    m.lzz = hn::MulAdd(slope, z, m.lzz);
    m.cxx = hn::MulAdd(wz, hn::GatherIndex(d, s.moment[slot] + j * 2, lane8), m.cxx);
    m.czx = hn::MulAdd(wz, hn::GatherIndex(d, s.moment[slot] + j * 2 + 1, lane8), m.czx);
    m.lxx = hn::MulAdd(wz, hn::GatherIndex(d, s.sloped[slot] + j * 2, lane8), m.lxx);
    m.lzx = hn::MulAdd(wz, hn::GatherIndex(d, s.sloped[slot] + j * 2 + 1, lane8), m.lzx);
  }
  const auto scale = hn::Set(d, 4.0 / (h * h));
  m.cxx = hn::Mul(m.cxx, scale);
  m.cxz = hn::Mul(m.cxz, scale);
  m.czx = hn::Mul(m.czx, scale);
  m.czz = hn::Mul(m.czz, scale);
  return m;
}

template <class D>
struct Sums {
  hn::Vec<D> work, px, pz, fastest;
};

// Velocity, gradient, stress and position of the particles i .. i+N of a block.
template <class D>
HWY_INLINE void update(D d, Particles& p, std::size_t i, std::size_t slot, const Grid& grid,
                       const G2pScratch& s, const LawTable& laws, double dt, bool move,
                       Sums<D>& sums) {
  const auto at = particle_spline(d, &p.x[i], &p.z[i], grid.h, grid.rows);
  const auto m = motion_at(d, at, slot, s, grid.h);
  hn::StoreU(m.vx, d, &p.vx[i]);
  hn::StoreU(m.vz, d, &p.vz[i]);
  hn::StoreU(m.cxx, d, &p.cxx[i]);
  hn::StoreU(m.cxz, d, &p.cxz[i]);
  hn::StoreU(m.czx, d, &p.czx[i]);
  hn::StoreU(m.czz, d, &p.czz[i]);

  const auto step = hn::Set(d, dt), half_step = hn::Set(d, 0.5 * dt);
  const PlaneStrain<hn::Vec<D>> strain{hn::Mul(m.lxx, step), hn::Mul(m.lzz, step),
                                       hn::Mul(hn::Add(m.lxz, m.lzx), half_step)};
  const auto spin = hn::Mul(hn::Sub(m.lxz, m.lzx), half_step);
  const auto power = update_stress(d, p, i, laws, strain, spin);
  const auto volume = hn::LoadU(d, &p.volume[i]);
  sums.work = hn::MulAdd(power, volume, sums.work);
  const auto mass = hn::LoadU(d, &p.mass[i]);
  sums.px = hn::MulAdd(mass, m.vx, sums.px);
  sums.pz = hn::MulAdd(mass, m.vz, sums.pz);
  sums.fastest = hn::Max(sums.fastest, hn::MulAdd(m.vx, m.vx, hn::Mul(m.vz, m.vz)));
  if (move) {
    hn::StoreU(hn::MulAdd(m.vx, step, hn::LoadU(d, &p.x[i])), d, &p.x[i]);
    hn::StoreU(hn::MulAdd(m.vz, step, hn::LoadU(d, &p.z[i])), d, &p.z[i]);
    const auto growth = hn::Add(strain.xx, strain.zz);
    hn::StoreU(hn::MulAdd(volume, growth, volume), d, &p.volume[i]);
  }
}

ParticleSums GridToParticles(Particles& p, const Grid& grid, const LawTable& laws, double dt,
                             bool move) {
  const hn::CappedTag<double, 8> d;
  constexpr std::size_t n = hn::MaxLanes(hn::CappedTag<double, 8>());
  G2pScratch s;
  Sums<hn::CappedTag<double, 8>> sums{hn::Zero(d), hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  for (std::size_t first = 0; first < p.count; first += block) {
    const std::size_t padded = std::min(block, p.padded() - first);
    for (std::size_t i = 0; i < padded; i += n) weigh(d, p, first + i, i, grid, s);
    for (std::size_t i = 0; i < padded; ++i) gather_columns(grid, i, s);
    for (std::size_t i = 0; i < padded; i += n) {
      update(hn::CappedTag<double, 8>(), p, first + i, i, grid, s, laws, dt, move, sums);
    }
  }
  return {hn::GetLane(hn::SumOfLanes(d, sums.work)), hn::GetLane(hn::SumOfLanes(d, sums.px)),
          hn::GetLane(hn::SumOfLanes(d, sums.pz)), hn::GetLane(hn::MaxOfLanes(d, sums.fastest))};
}

}  // namespace HWY_NAMESPACE
}  // namespace leda::solver
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace leda::solver {

HWY_EXPORT(ParticlesToGrid);
HWY_EXPORT(GridToParticles);

void particles_to_grid(const Particles& particles, Grid& grid) {
  HWY_DYNAMIC_DISPATCH(ParticlesToGrid)(particles, grid);
}

ParticleSums grid_to_particles(Particles& particles, const Grid& grid, const LawTable& laws,
                               double dt, bool move) {
  return HWY_DYNAMIC_DISPATCH(GridToParticles)(particles, grid, laws, dt, move);
}

}  // namespace leda::solver
#endif
