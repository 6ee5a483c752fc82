#include "solver/screening/morgenstern_price.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "solver/screening/bishop.hpp"

namespace leda::solver {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

/// f at every edge between slices, both ends included.
std::vector<double> interslice_function(const std::vector<Slice>& slices, Interslice shape) {
  std::vector<double> f(slices.size() + 1, 1.0);
  if (shape == Interslice::constant) return f;
  double span = 0;
  for (const Slice& s : slices) span += s.width;
  double x = 0;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    f[i] = std::sin(std::numbers::pi * x / span);
    x += slices[i].width;
  }
  f.back() = 0;
  return f;
}

double phi_of(const Slice& s, double lambda_f, double factor) {
  return (s.sin_a - lambda_f * s.cos_a) * s.resistance.tan_phi +
         (s.cos_a + lambda_f * s.sin_a) * factor;
}

/// Resistance and drive of one slice without its interslice forces.
struct OwnForces {
  double resisting = 0, driving = 0;
};

OwnForces own_forces(const Slice& s) {
  const Resistance& r = s.resistance;
  const double normal = s.weight * s.cos_a - r.pore_pressure * s.length;
  return {normal * r.tan_phi + r.cohesion * s.length, s.weight * s.sin_a};
}

/// Factor from the balance of forces: E at the lower end is zero.
double force_factor(const std::vector<Slice>& slices, const std::vector<double>& f, double lambda,
                    double factor) {
  double resisting = 0;
  double driving = 0;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    const OwnForces own = own_forces(slices[i]);
    // What came before is carried over by Psi: Phi of this slice over Phi of the last, at the
    // edge they share.
    if (i > 0) {
      const double carried =
          phi_of(slices[i], lambda * f[i], factor) / phi_of(slices[i - 1], lambda * f[i], factor);
      resisting *= carried;
      driving *= carried;
    }
    resisting += own.resisting;
    driving += own.driving;
  }
  return driving > 0 && resisting > 0 ? resisting / driving : none;
}

/// What is out of balance in the moments of all slices, and its size for comparison.
struct Imbalance {
  double value = 0;
  double scale = 0;
};

Imbalance moment_imbalance(const std::vector<Slice>& slices, const std::vector<double>& f,
                           double lambda, double factor) {
  double upper = 0;  // E at the upper edge of the slice
  Imbalance sum;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    const Slice& s = slices[i];
    const OwnForces own = own_forces(s);
    const double pushed = upper * phi_of(s, lambda * f[i], factor);
    const double lower =
        (pushed + factor * own.driving - own.resisting) / phi_of(s, lambda * f[i + 1], factor);
    sum.value += s.width *
                 ((upper + lower) * s.sin_a / s.cos_a - lambda * (f[i] * upper + f[i + 1] * lower));
    sum.scale += s.width * std::abs(upper + lower);
    upper = lower;
  }
  return sum;
}

/// A factor that balances the forces for one lambda, and what then remains of the moments.
struct Trial {
  double lambda = 0;
  double factor = none;
  double imbalance = none;  ///< relative

  bool holds() const { return std::isfinite(imbalance); }
};

Trial balance_forces(const std::vector<Slice>& slices, const std::vector<double>& f, double lambda,
                     double guess) {
  double factor = guess;
  for (int pass = 0; pass < 60; ++pass) {
    const double next = force_factor(slices, f, lambda, factor);
    if (!std::isfinite(next)) return {lambda, none, none};
    const bool settled = std::abs(next - factor) < 1e-7 * next;
    factor = next;
    if (settled) {
      const Imbalance moments = moment_imbalance(slices, f, lambda, factor);
      return {lambda, factor, moments.value / moments.scale};
    }
  }
  return {lambda, none, none};
}

/// Between two trials whose imbalances have opposite signs (Illinois form of the false position).
Trial close_in(const std::vector<Slice>& slices, const std::vector<double>& f, Trial a, Trial b) {
  double weight_a = a.imbalance;
  double weight_b = b.imbalance;
  for (int pass = 0; pass < 40; ++pass) {
    const double lambda = (a.lambda * weight_b - b.lambda * weight_a) / (weight_b - weight_a);
    const Trial c = balance_forces(slices, f, lambda, a.factor);
    if (!c.holds()) return c;
    if (std::abs(c.imbalance) < 1e-6 || std::abs(b.lambda - a.lambda) < 1e-7) return c;
    if ((c.imbalance > 0) == (a.imbalance > 0)) {
      a = c;
      weight_a = c.imbalance;
      weight_b *= 0.5;
    } else {
      b = c;
      weight_b = c.imbalance;
      weight_a *= 0.5;
    }
  }
  return {};
}

}  // namespace

double morgenstern_price(const std::vector<Slice>& slices, Interslice shape) {
  // There the balance of forces only fixes lambda, and where the crest is in tension none does.
  if (is_frictionless_arc(slices)) return bishop(slices);
  const std::vector<double> f = interslice_function(slices, shape);
  const Trial start = balance_forces(slices, f, 0, 1);
  if (!start.holds()) return none;
  // Outwards from lambda = 0, on the side where the moments call for shear first.
  for (const double side : {start.imbalance > 0 ? 1.0 : -1.0, start.imbalance > 0 ? -1.0 : 1.0}) {
    Trial last = start;
    for (const double size : {0.2, 0.4, 0.8, 1.6, 3.2}) {
      const Trial next = balance_forces(slices, f, side * size, last.factor);
      if (!next.holds()) break;
      if ((next.imbalance > 0) != (last.imbalance > 0)) {
        return close_in(slices, f, last, next).factor;
      }
      last = next;
    }
  }
  return none;
}

}  // namespace leda::solver
