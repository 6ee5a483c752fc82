// Stress update of a vector of particles, once for each instruction set: elastic, 3D Tresca,
// strength by the softening curve of the particle's law, Jaumann rate, plane strain.

#if defined(LEDA_SOLVER_TRESCA_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_TRESCA_INL
#undef LEDA_SOLVER_TRESCA_INL
#else
#define LEDA_SOLVER_TRESCA_INL
#endif

#include "hwy/contrib/math/math-inl.h"
#include "hwy/highway.h"
#include "solver/materials/law_rows-inl.hpp"
#include "solver/materials/viscous-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// In-plane components of a symmetric tensor; xz is the tensor component, not the engineering one.
template <class V>
struct PlaneStrain {
  V xx, zz, xz;
};

template <class V>
struct Moduli {
  V bulk, shear;  ///< Pa
};

template <class V>
struct PlaneStress {
  V xx, zz, xz, yy;
};

/// A constant in the type of the lanes.
template <class D>
HWY_INLINE hn::Vec<D> constant(D d, double value) {
  return hn::Set(d, static_cast<hn::TFromD<D>>(value));
}

/// Where exp is as good as zero and still a normal number.
template <class D>
constexpr double no_exponent = sizeof(hn::TFromD<D>) == 4 ? -80.0 : -700.0;

/// s_u at the start of the step: the peak until the first yield, then the curve.
template <class D, class Laws>
HWY_INLINE hn::Vec<D> strength_now(D d, const LawRows<D>& row, const Laws& laws, hn::Vec<D> gamma) {
  const auto peak = row(laws.peak);
  const auto yielded = hn::Gt(gamma, hn::Zero(d));
  if (HWY_LIKELY(hn::AllFalse(d, yielded))) return peak;
  const auto exponent = hn::Neg(hn::Mul(row(laws.rate), gamma));
  auto s = hn::MulAdd(row(laws.amplitude),
                      hn::Exp(d, hn::Max(exponent, constant(d, no_exponent<D>))), row(laws.floor));
  s = hn::Min(s, peak);
  const auto beyond = hn::Sub(gamma, row(laws.exp_end));
  const auto line = hn::MulAdd(row(laws.line_slope), beyond, row(laws.line_start));
  s = hn::IfThenElse(hn::Gt(beyond, hn::Zero(d)), line, s);
  s = hn::IfThenElse(hn::Ge(gamma, row(laws.line_end)), row(laws.last), s);
  return hn::IfThenElse(yielded, s, peak);
}

/// Principal stresses returned to the Tresca surface by closest projection in the elastic
/// metric (de Souza Neto et al. 2008, 8.2: main plane, left and right corner), mean unchanged.
template <class D>
struct TrescaReturn {
  hn::Vec<D> high, mid, low, plastic_strain;
};

/// Tresca for high >= mid >= low (trial, Pa), shear strength s and shear modulus g.
template <class D>
HWY_INLINE TrescaReturn<D> tresca_return(D d, hn::Vec<D> high, hn::Vec<D> mid, hn::Vec<D> low,
                                         hn::Vec<D> s, hn::Vec<D> g) {
  const auto half = constant(d, 0.5), third = constant(d, 1.0 / 3.0);
  const auto excess = hn::Max(hn::Sub(hn::Sub(high, low), hn::Add(s, s)), hn::Zero(d));
  const auto h1 = hn::NegMulAdd(half, excess, high), l1 = hn::MulAdd(half, excess, low);
  const auto sum = hn::Add(hn::Add(high, mid), low);
  const auto two = hn::Add(s, s), four = hn::Add(two, two);
  const auto top = hn::Gt(mid, h1), bottom = hn::Lt(mid, l1);  // never both: high - low >= 2 s
  const auto top_high = hn::Mul(third, hn::Add(sum, two));
  const auto top_low = hn::Mul(third, hn::Sub(sum, four));
  const auto bottom_high = hn::Mul(third, hn::Add(sum, four));
  const auto bottom_low = hn::Mul(third, hn::Sub(sum, two));
  TrescaReturn<D> r;
  r.high = hn::IfThenElse(top, top_high, hn::IfThenElse(bottom, bottom_high, h1));
  r.low = hn::IfThenElse(top, top_low, hn::IfThenElse(bottom, bottom_low, l1));
  r.mid = hn::IfThenElse(top, top_high, hn::IfThenElse(bottom, bottom_low, mid));
  const auto dh = hn::Sub(high, r.high), dm = hn::Sub(mid, r.mid), dl = hn::Sub(low, r.low);
  const auto square = hn::MulAdd(dh, dh, hn::MulAdd(dm, dm, hn::Mul(dl, dl)));
  // gamma = sqrt(2 e:e) with e = ds / (2 G): the engineering strain in simple shear.
  r.plastic_strain = hn::Div(hn::Sqrt(hn::Mul(half, square)), g);
  return r;
}

/// Engineering shear strain sqrt(2 e':e') of a plane strain increment.
template <class D>
HWY_INLINE hn::Vec<D> shear_strain(D d, const PlaneStrain<hn::Vec<D>>& e) {
  const auto mean = hn::Mul(hn::Set(d, 1.0 / 3.0), hn::Add(e.xx, e.zz));
  const auto x = hn::Sub(e.xx, mean), z = hn::Sub(e.zz, mean);
  const auto normal = hn::MulAdd(x, x, hn::MulAdd(z, z, hn::Mul(mean, mean)));
  const auto square = hn::MulAdd(hn::Add(e.xz, e.xz), e.xz, normal);
  return hn::Sqrt(hn::Add(square, square));
}

template <class D>
struct StressStep {
  PlaneStress<hn::Vec<D>> stress;
  hn::Vec<D> plastic_strain;  ///< of this step
  hn::Vec<D> work;            ///< of the mid-step stress per volume, Pa
  bool yields;                ///< whether any lane does; else plastic_strain is zero
};

/// Stress after a strain increment and a rotation `spin` = w_xz dt, w = (dvx/dz - dvz/dx) / 2,
/// from stress `old` and plastic strain `gamma`, in dt seconds, with the moduli given.
/// `Viscous`: laws.viscous is used.
template <bool Viscous, class D, class Laws>
HWY_INLINE StressStep<D> next_stress(D d, const LawRows<D>& row, const Laws& laws,
                                     const PlaneStress<hn::Vec<D>>& old, hn::Vec<D> gamma,
                                     const PlaneStrain<hn::Vec<D>>& e, hn::Vec<D> spin,
                                     hn::Vec<D> dt, const Moduli<hn::Vec<D>>& moduli) {
  const auto g = moduli.shear, bulk = moduli.bulk;
  const auto g2 = hn::Add(g, g), half = constant(d, 0.5);
  const auto lame = hn::NegMulAdd(constant(d, 2.0 / 3.0), g, bulk);
  const auto pressure = hn::Mul(lame, hn::Add(e.xx, e.zz));
  const auto turn = hn::Add(spin, spin);
  auto xx = hn::Add(hn::MulAdd(g2, e.xx, pressure), hn::MulAdd(turn, old.xz, old.xx));
  auto zz = hn::Add(hn::MulAdd(g2, e.zz, pressure), hn::NegMulAdd(turn, old.xz, old.zz));
  auto xz = hn::MulAdd(g2, e.xz, hn::MulAdd(spin, hn::Sub(old.zz, old.xx), old.xz));
  auto yy = hn::Add(old.yy, pressure);

  auto s = strength_now(d, row, laws, gamma);
  if constexpr (Viscous) {
    s = hn::Mul(s, rate_factor(d, row, laws.viscous, hn::Div(shear_strain(d, e), dt)));
  }
  const auto centre = hn::Mul(half, hn::Add(xx, zz)), apart = hn::Mul(half, hn::Sub(xx, zz));
  const auto radius = hn::Sqrt(hn::MulAdd(apart, apart, hn::Mul(xz, xz)));
  const auto a = hn::Add(centre, radius), b = hn::Sub(centre, radius);
  const auto high = hn::Max(a, yy), low = hn::Min(b, yy);
  const auto yields = hn::Gt(hn::Sub(high, low), hn::Add(s, s));
  auto plastic = hn::Zero(d);
  const bool any = !hn::AllFalse(d, yields);
  if (any) {
    if constexpr (Viscous) {  // what is left beyond yield is the viscous stress of this step
      const auto excess = hn::MulSub(half, hn::Sub(high, low), s);
      const auto flowed = flow_strain(d, row, laws.viscous, excess, g, dt);
      s = hn::IfThenElse(yields, hn::NegMulAdd(g, flowed, hn::Add(s, excess)), s);
    }
    const auto yy_high = hn::Gt(yy, a), yy_low = hn::Lt(yy, b);
    const auto mid = hn::IfThenElse(yy_high, a, hn::IfThenElse(yy_low, b, yy));
    const auto r = tresca_return(d, high, mid, low, s, g);
    const auto new_a = hn::IfThenElse(yy_high, r.mid, r.high);
    const auto new_b = hn::IfThenElse(yy_low, r.mid, r.low);
    const auto new_yy = hn::IfThenElse(yy_high, r.high, hn::IfThenElse(yy_low, r.low, r.mid));
    const auto new_centre = hn::Mul(half, hn::Add(new_a, new_b));
    const auto new_radius = hn::Mul(half, hn::Sub(new_a, new_b));
    const auto shrink = hn::Div(new_radius, hn::Max(radius, constant(d, 1e-30)));
    xx = hn::IfThenElse(yields, hn::MulAdd(apart, shrink, new_centre), xx);
    zz = hn::IfThenElse(yields, hn::NegMulAdd(apart, shrink, new_centre), zz);
    xz = hn::IfThenElse(yields, hn::Mul(xz, shrink), xz);
    yy = hn::IfThenElse(yields, new_yy, yy);
    plastic = hn::IfThenElseZero(yields, r.plastic_strain);
  }
  const auto normal = hn::MulAdd(hn::Add(old.xx, xx), e.xx, hn::Mul(hn::Add(old.zz, zz), e.zz));
  const auto shear = hn::Mul(hn::Add(old.xz, xz), hn::Add(e.xz, e.xz));
  return {{xx, zz, xz, yy}, plastic, hn::Mul(half, hn::Add(normal, shear)), any};
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
