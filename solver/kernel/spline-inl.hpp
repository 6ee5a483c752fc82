// Quadratic B-spline weights of a vector of particles, once for each instruction set.

#if defined(LEDA_SOLVER_SPLINE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_SPLINE_INL
#undef LEDA_SOLVER_SPLINE_INL
#else
#define LEDA_SOLVER_SPLINE_INL
#endif

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t block = 64;  // particles whose scratch stays in the first-level cache

/// Weights, their slopes (1/m) and distances (node minus particle, m) for the three nodes on each
/// axis, and the lowest node of the first column.
template <class D>
struct ParticleSpline {
  hn::Vec<D> wx[3], wz[3], slope_x[3], slope_z[3], dx[3], dz[3];
  hn::Vec<hn::RebindToSigned<D>> node;
};

/// w(r) = 3/4 - r^2 for |r| < 1/2, (3/2 - |r|)^2 / 2 up to 3/2, r in cells (Steffen et al. 2008).
/// Node 0 of the grid lies one cell below the origin of the positions.
template <class D>
HWY_INLINE ParticleSpline<D> particle_spline(D d, const double* x, const double* z, double h,
                                             std::size_t rows) {
  ParticleSpline<D> s;
  const auto half = hn::Set(d, 0.5), one = hn::Set(d, 1.0), side = hn::Set(d, h);
  const auto per_h = hn::Set(d, 1.0 / h);
  const auto weights = [&](hn::Vec<D> f, hn::Vec<D>* w, hn::Vec<D>* slope, hn::Vec<D>* distance) {
    const auto a = hn::Sub(hn::Set(d, 1.5), f), b = hn::Sub(f, one), c = hn::Sub(f, half);
    w[0] = hn::Mul(half, hn::Mul(a, a));
    w[1] = hn::NegMulAdd(b, b, hn::Set(d, 0.75));
    w[2] = hn::Mul(half, hn::Mul(c, c));
    slope[0] = hn::Neg(hn::Mul(a, per_h));
    slope[1] = hn::Mul(hn::Mul(hn::Set(d, -2.0), b), per_h);
    slope[2] = hn::Mul(c, per_h);
    distance[0] = hn::Neg(hn::Mul(f, side));
    distance[1] = hn::Add(distance[0], side);
    distance[2] = hn::Add(distance[1], side);
  };
  const auto gx = hn::MulAdd(hn::LoadU(d, x), per_h, one);
  const auto gz = hn::MulAdd(hn::LoadU(d, z), per_h, one);
  const auto column = hn::Floor(hn::Sub(gx, half)), row = hn::Floor(hn::Sub(gz, half));
  weights(hn::Sub(gx, column), s.wx, s.slope_x, s.dx);
  weights(hn::Sub(gz, row), s.wz, s.slope_z, s.dz);
  const auto node = hn::MulAdd(column, hn::Set(d, static_cast<double>(rows)), row);
  s.node =
      hn::PromoteTo(hn::RebindToSigned<D>(), hn::DemoteTo(hn::Rebind<std::int32_t, D>(), node));
  return s;
}

/// Writes the weights of the three columns, the same times the distance and the slopes, one row
/// of four a particle.
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

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
