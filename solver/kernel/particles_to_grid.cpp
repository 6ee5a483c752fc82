#include "solver/kernel/transfer.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solver/kernel/particles_to_grid.cpp"
#include "hwy/foreach_target.h"
//
#include "hwy/highway.h"
#include "solver/kernel/span-inl.hpp"
#include "solver/kernel/spline-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

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

// What the particles i .. i+N of a block give to the nodes of their three columns.
// `Average`: the mean of the in-plane normal stresses is replaced by its mean over the span, the
// counterpart of averaged dilation (grid_to_particles.cpp): force and strain stay conjugate.
template <bool Average, class D>
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
  auto sxx = hn::LoadU(d, &p.sxx[i]), szz = hn::LoadU(d, &p.szz[i]);
  if constexpr (Average) {
    const auto own = hn::Mul(hn::Set(d, 0.5), hn::Add(sxx, szz));
    const auto to_mean = hn::Sub(span_mean(d, grid, at.node, 1), own);
    sxx = hn::Add(sxx, to_mean);
    szz = hn::Add(szz, to_mean);
  }
  const auto fxx = hn::Mul(volume, sxx), fzz = hn::Mul(volume, szz);
  const auto fxz = hn::Mul(volume, hn::LoadU(d, &p.sxz[i]));
  const auto lane16 = hn::ShiftLeft<4>(hn::Iota(hn::RebindToSigned<D>(), 0));
  for (std::size_t j = 0; j < 3; ++j) {
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

void AddPressure(const Particles& p, Grid& grid) {
  const hn::CappedTag<double, 8> d;
  HWY_ALIGN std::int64_t node[8];
  for (std::size_t i = 0; i < p.count; i += hn::Lanes(d)) {
    hn::Store(particle_spline(d, &p.x[i], &p.z[i], grid.h, grid.rows).node,
              hn::RebindToSigned<decltype(d)>(), node);
    for (std::size_t l = 0; l < std::min(hn::Lanes(d), p.count - i); ++l) {
      double* span = &grid.span[static_cast<std::size_t>(node[l]) * 3];
      span[0] += p.volume[i + l];
      span[1] += p.volume[i + l] * 0.5 * (p.sxx[i + l] + p.szz[i + l]);
    }
  }
}

template <bool Average>
HWY_INLINE void all_to_grid(const Particles& p, Grid& grid) {
  const hn::CappedTag<double, 8> d;
  constexpr std::size_t n = hn::MaxLanes(hn::CappedTag<double, 8>());
  constexpr std::size_t parts = 16 / n;
  P2gScratch s{};
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
    for (std::size_t i = 0; i < padded; i += n) spread<Average>(d, p, first + i, i, grid, s);
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

void ParticlesToGrid(const Particles& p, Grid& grid) {
  if (!grid.averages()) return all_to_grid<false>(p, grid);
  AddPressure(p, grid);
  all_to_grid<true>(p, grid);
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace leda::solver {

HWY_EXPORT(ParticlesToGrid);

void particles_to_grid(const Particles& particles, Grid& grid) {
  HWY_DYNAMIC_DISPATCH(ParticlesToGrid)(particles, grid);
}

}  // namespace leda::solver
#endif
