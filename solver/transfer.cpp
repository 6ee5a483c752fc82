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

struct P2gScratch {
  HWY_ALIGN double near_part[block][16];  // what a node gets, times wx
  HWY_ALIGN double far_part[block][16];   // what it gets, times wx (x_i - x_p)
  HWY_ALIGN double wx[block][8];          // wx of three columns, then wx dx of three columns
  HWY_ALIGN std::int64_t node[block];     // lowest node of the first column
};

// What the particles i .. i+N of a block give to the nodes of their three columns.
template <class D>
HWY_INLINE void spread(D d, const Particles& p, std::size_t i, std::size_t slot, const Grid& grid,
                       P2gScratch& s) {
  const double h = grid.h;
  const auto at = particle_spline(d, &p.x[i], &p.z[i], h, grid.rows);
  hn::Store(at.node, hn::RebindToSigned<D>(), &s.node[slot]);
  const auto mass = hn::LoadU(d, &p.mass[i]);
  const auto k = hn::Mul(hn::LoadU(d, &p.volume[i]), hn::Set(d, -4.0 / (h * h)));
  const auto sxz = hn::Mul(k, hn::LoadU(d, &p.sxz[i]));
  const decltype(mass) start[5] = {mass, hn::Mul(mass, hn::LoadU(d, &p.vx[i])),
                                   hn::Mul(mass, hn::LoadU(d, &p.vz[i])), hn::Zero(d), hn::Zero(d)};
  const decltype(mass) along_x[4] = {hn::Mul(mass, hn::LoadU(d, &p.cxx[i])),
                                     hn::Mul(mass, hn::LoadU(d, &p.czx[i])),
                                     hn::Mul(k, hn::LoadU(d, &p.sxx[i])), sxz};
  const decltype(mass) along_z[4] = {hn::Mul(mass, hn::LoadU(d, &p.cxz[i])),
                                     hn::Mul(mass, hn::LoadU(d, &p.czz[i])), sxz,
                                     hn::Mul(k, hn::LoadU(d, &p.szz[i]))};
  const auto lane16 = hn::ShiftLeft<4>(hn::Iota(hn::RebindToSigned<D>(), 0));
  const auto lane8 = hn::ShiftLeft<3>(hn::Iota(hn::RebindToSigned<D>(), 0));
  double* near_part = &s.near_part[slot][0];
  double* far_part = &s.far_part[slot][0];
  for (int j = 0; j < 3; ++j) {
    hn::ScatterIndex(hn::Mul(at.wz[j], mass), d, near_part + j * 5, lane16);
    for (int v = 0; v < 4; ++v) {
      const auto value = hn::MulAdd(at.dz[j], along_z[v], start[v + 1]);
      hn::ScatterIndex(hn::Mul(at.wz[j], value), d, near_part + j * 5 + v + 1, lane16);
      hn::ScatterIndex(hn::Mul(at.wz[j], along_x[v]), d, far_part + j * 5 + v + 1, lane16);
    }
    hn::ScatterIndex(at.wx[j], d, &s.wx[slot][0] + j, lane8);
    hn::ScatterIndex(hn::Mul(at.wx[j], at.dx[j]), d, &s.wx[slot][0] + 3 + j, lane8);
  }
}

void ParticlesToGrid(const Particles& p, Grid& grid) {
  const hn::CappedTag<double, 8> d;
  constexpr std::size_t n = hn::MaxLanes(hn::CappedTag<double, 8>());
  constexpr std::size_t parts = 16 / n;
  P2gScratch s;
  std::fill(&s.near_part[0][0], &s.near_part[0][0] + block * 16, 0.0);
  std::fill(&s.far_part[0][0], &s.far_part[0][0] + block * 16, 0.0);
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
        const auto wxdx = hn::Set(d, s.wx[i][3 + c]);
        for (std::size_t l = 0; l < parts; ++l) {
          const auto part = hn::MulAdd(wx, hn::Load(d, &s.near_part[i][l * n]), sum[c][l]);
          sum[c][l] = hn::MulAdd(wxdx, hn::Load(d, &s.far_part[i][l * n]), part);
        }
      }
    }
  }
  if (cell >= 0) flush(cell);
}

struct G2pScratch {
  HWY_ALIGN double plain[block][8];   // sum over columns of wx v, for three nodes and two axes
  HWY_ALIGN double moment[block][8];  // the same with wx (x_i - x_p)
  HWY_ALIGN double wx[block][8];
  HWY_ALIGN std::int64_t node[block];
};

template <class D>
HWY_INLINE void weigh(D d, const Particles& p, std::size_t i, std::size_t slot, const Grid& grid,
                      G2pScratch& s) {
  const auto at = particle_spline(d, &p.x[i], &p.z[i], grid.h, grid.rows);
  hn::Store(at.node, hn::RebindToSigned<D>(), &s.node[slot]);
  const auto lane8 = hn::ShiftLeft<3>(hn::Iota(hn::RebindToSigned<D>(), 0));
  for (int j = 0; j < 3; ++j) {
    hn::ScatterIndex(at.wx[j], d, &s.wx[slot][0] + j, lane8);
    hn::ScatterIndex(hn::Mul(at.wx[j], at.dx[j]), d, &s.wx[slot][0] + 3 + j, lane8);
  }
}

HWY_INLINE void gather_columns(const Grid& grid, std::size_t i, G2pScratch& s) {
  const hn::CappedTag<double, 8> d;
  constexpr std::size_t n = hn::MaxLanes(hn::CappedTag<double, 8>());
  const double* from = &grid.velocity[static_cast<std::size_t>(s.node[i]) * 2];
  for (std::size_t l = 0; l < 8; l += n) {
    auto plain = hn::Zero(d);
    auto moment = hn::Zero(d);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto v = hn::LoadU(d, from + c * grid.rows * 2 + l);
      plain = hn::MulAdd(hn::Set(d, s.wx[i][c]), v, plain);
      moment = hn::MulAdd(hn::Set(d, s.wx[i][3 + c]), v, moment);
    }
    hn::Store(plain, d, &s.plain[i][l]);
    hn::Store(moment, d, &s.moment[i][l]);
  }
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
  const auto lane8 = hn::ShiftLeft<3>(hn::Iota(hn::RebindToSigned<D>(), 0));
  auto vx = hn::Zero(d), vz = vx, cxx = vx, cxz = vx, czx = vx, czz = vx;
  for (int j = 0; j < 3; ++j) {
    const double* plain = &s.plain[slot][0] + j * 2;
    const double* moment = &s.moment[slot][0] + j * 2;
    const auto wx = hn::Mul(at.wz[j], hn::GatherIndex(d, plain, lane8));
    const auto wz = hn::Mul(at.wz[j], hn::GatherIndex(d, plain + 1, lane8));
    vx = hn::Add(vx, wx);
    vz = hn::Add(vz, wz);
    cxz = hn::MulAdd(wx, at.dz[j], cxz);
    czz = hn::MulAdd(wz, at.dz[j], czz);
    cxx = hn::MulAdd(at.wz[j], hn::GatherIndex(d, moment, lane8), cxx);
    czx = hn::MulAdd(at.wz[j], hn::GatherIndex(d, moment + 1, lane8), czx);
  }
  const auto scale = hn::Set(d, 4.0 / (grid.h * grid.h));
  cxx = hn::Mul(cxx, scale);
  cxz = hn::Mul(cxz, scale);
  czx = hn::Mul(czx, scale);
  czz = hn::Mul(czz, scale);
  hn::StoreU(vx, d, &p.vx[i]);
  hn::StoreU(vz, d, &p.vz[i]);
  hn::StoreU(cxx, d, &p.cxx[i]);
  hn::StoreU(cxz, d, &p.cxz[i]);
  hn::StoreU(czx, d, &p.czx[i]);
  hn::StoreU(czz, d, &p.czz[i]);

  const auto step = hn::Set(d, dt);
  PlaneStrain<hn::Vec<D>> strain;
  strain.xx = hn::Mul(cxx, step);
  strain.zz = hn::Mul(czz, step);
  strain.xz = hn::Mul(hn::Mul(hn::Add(cxz, czx), step), hn::Set(d, 0.5));
  const auto spin = hn::Mul(hn::Mul(hn::Sub(cxz, czx), step), hn::Set(d, 0.5));
  const auto power = update_stress(d, p, i, laws, strain, spin);
  const auto volume = hn::LoadU(d, &p.volume[i]);
  sums.work = hn::MulAdd(power, volume, sums.work);
  const auto mass = hn::LoadU(d, &p.mass[i]);
  sums.px = hn::MulAdd(mass, vx, sums.px);
  sums.pz = hn::MulAdd(mass, vz, sums.pz);
  sums.fastest = hn::Max(sums.fastest, hn::MulAdd(vx, vx, hn::Mul(vz, vz)));
  if (move) {
    hn::StoreU(hn::MulAdd(vx, step, hn::LoadU(d, &p.x[i])), d, &p.x[i]);
    hn::StoreU(hn::MulAdd(vz, step, hn::LoadU(d, &p.z[i])), d, &p.z[i]);
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
