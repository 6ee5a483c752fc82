#include "solver/kernel/transfer.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solver/kernel/grid_to_particles.cpp"
#include "hwy/foreach_target.h"
//
#include "hwy/highway.h"
#include "solver/kernel/span-inl.hpp"
#include "solver/kernel/spline-inl.hpp"
#include "solver/materials/tresca-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

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
  for (std::size_t j = 0; j < 3; ++j) {
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

// Adds the dilation of a step to the sums of the spans.
template <class D>
HWY_INLINE void add_dilation(D d, const Particles& p, std::size_t i, std::size_t slot, Grid& grid,
                             const G2pScratch& s, double dt) {
  const auto at = particle_spline(d, &p.x[i], &p.z[i], grid.h, grid.rows);
  const auto m = motion_at(d, at, slot, s, grid.h);
  HWY_ALIGN double dilation[8];
  const auto own = hn::Mul(hn::Set(d, dt), hn::Add(m.lxx, m.lzz));
  hn::Store(hn::Mul(hn::LoadU(d, &p.volume[i]), own), d, dilation);
  for (std::size_t l = 0; l < hn::Lanes(d) && i + l < p.count; ++l) {
    grid.span[static_cast<std::size_t>(s.node[slot + l]) * 3 + 2] += dilation[l];
  }
}

// Stress and plastic strain of the particles i .. i+N; returns the work per volume.
template <bool Viscous, class D>
HWY_INLINE hn::Vec<D> update_stress(D d, Particles& p, std::size_t i, const LawTable& laws,
                                    const PlaneStrain<hn::Vec<D>>& e, hn::Vec<D> spin,
                                    hn::Vec<D> dt) {
  const PlaneStress<hn::Vec<D>> old{hn::LoadU(d, &p.sxx[i]), hn::LoadU(d, &p.szz[i]),
                                    hn::LoadU(d, &p.sxz[i]), hn::LoadU(d, &p.syy[i])};
  const auto gamma = hn::LoadU(d, &p.plastic_strain[i]);
  const auto row = law_rows(d, &p.law[i], laws.rows(), false);
  const auto next = next_stress<Viscous>(d, row, laws, old, gamma, e, spin, dt,
                                         Moduli<hn::Vec<D>>{row(laws.bulk), row(laws.shear)});
  if (next.yields) hn::StoreU(hn::Add(gamma, next.plastic_strain), d, &p.plastic_strain[i]);
  hn::StoreU(next.stress.xx, d, &p.sxx[i]);
  hn::StoreU(next.stress.zz, d, &p.szz[i]);
  hn::StoreU(next.stress.xz, d, &p.sxz[i]);
  hn::StoreU(next.stress.yy, d, &p.syy[i]);
  return next.work;
}

// Velocity, gradient, stress and position of the particles i .. i+N of a block.
template <bool Average, bool Viscous, class D>
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
  PlaneStrain<hn::Vec<D>> strain{hn::Mul(m.lxx, step), hn::Mul(m.lzz, step),
                                 hn::Mul(hn::Add(m.lxz, m.lzx), half_step)};
  if constexpr (Average) {
    const auto own = hn::Add(strain.xx, strain.zz);
    const auto to_mean = hn::Mul(hn::Set(d, 0.5), hn::Sub(span_mean(d, grid, at.node, 2), own));
    strain.xx = hn::Add(strain.xx, to_mean);
    strain.zz = hn::Add(strain.zz, to_mean);
  }
  const auto spin = hn::Mul(hn::Sub(m.lxz, m.lzx), half_step);
  const auto power = update_stress<Viscous>(d, p, i, laws, strain, spin, step);
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

// Calls one(first, i) for each vector of particles of each block, with its columns gathered.
template <class D, class One>
HWY_INLINE void for_each_vector(D d, const Particles& p, const Grid& grid, G2pScratch& s,
                                const One& one) {
  const std::size_t n = hn::Lanes(d);
  for (std::size_t first = 0; first < p.count; first += block) {
    const std::size_t padded = std::min(block, p.padded() - first);
    for (std::size_t i = 0; i < padded; i += n) weigh(d, p, first + i, i, grid, s);
    for (std::size_t i = 0; i < padded; ++i) gather_columns(grid, i, s);
    for (std::size_t i = 0; i < padded; i += n) one(first + i, i);
  }
}

template <bool Average, bool Viscous>
HWY_INLINE ParticleSums all_to_particles(Particles& p, Grid& grid, const LawTable& laws, double dt,
                                         bool move) {
  const hn::CappedTag<double, 8> d;
  G2pScratch s{};
  if constexpr (Average) {
    for_each_vector(d, p, grid, s, [&](std::size_t i, std::size_t slot) {
      add_dilation(d, p, i, slot, grid, s, dt);
    });
  }
  Sums<hn::CappedTag<double, 8>> sums{hn::Zero(d), hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  for_each_vector(d, p, grid, s, [&](std::size_t i, std::size_t slot) {
    update<Average, Viscous>(d, p, i, slot, grid, s, laws, dt, move, sums);
  });
  return {hn::GetLane(hn::SumOfLanes(d, sums.work)), hn::GetLane(hn::SumOfLanes(d, sums.px)),
          hn::GetLane(hn::SumOfLanes(d, sums.pz)), hn::GetLane(hn::MaxOfLanes(d, sums.fastest))};
}

ParticleSums GridToParticles(Particles& p, Grid& grid, const LawTable& laws, double dt, bool move) {
  const bool viscous = !laws.viscous.empty();
  if (grid.averages()) {
    return viscous ? all_to_particles<true, true>(p, grid, laws, dt, move)
                   : all_to_particles<true, false>(p, grid, laws, dt, move);
  }
  return viscous ? all_to_particles<false, true>(p, grid, laws, dt, move)
                 : all_to_particles<false, false>(p, grid, laws, dt, move);
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace leda::solver {

HWY_EXPORT(GridToParticles);

ParticleSums grid_to_particles(Particles& particles, Grid& grid, const LawTable& laws, double dt,
                               bool move) {
  return HWY_DYNAMIC_DISPATCH(GridToParticles)(particles, grid, laws, dt, move);
}

}  // namespace leda::solver
#endif
