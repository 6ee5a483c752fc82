#include "solver/element_test/dissipation.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>

namespace leda::solver {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Strain up to which the peak caps the exponential (alpha > 1); zero where it does not.
double capped_until(const SofteningCurve& c) {
  const double room = c.peak - c.floor;
  if (c.amplitude <= room || c.rate <= 0) return 0;
  return room <= 0 ? never : std::log(c.amplitude / room) / c.rate;
}

/// Area of the exponential above the floor between zero and a strain within the branch.
double exponential_area(const SofteningCurve& c, double strain) {
  const double flat = std::min(capped_until(c), strain);
  const double cap = std::min(c.amplitude, c.peak - c.floor);
  if (c.rate <= 0) return cap * strain;
  const double decay = std::exp(-c.rate * flat) - std::exp(-c.rate * strain);
  return cap * flat + c.amplitude / c.rate * decay;
}

/// Smooth pieces only, each cut further so that a decay of many e-foldings is resolved.
template <class F>
double integrate(const F& f, double from, double to, double e_foldings) {
  if (to <= from) return 0;
  const int pieces = std::clamp(static_cast<int>(std::ceil(e_foldings / 4)), 1, 64);
  double area = 0;
  for (int i = 0; i < pieces; ++i) {
    const double a = from + (to - from) * i / pieces;
    const double b = from + (to - from) * (i + 1) / pieces;
    area += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f, a, b, 8, 1e-13);
  }
  return area;
}

double exponential_by_quadrature(const SofteningCurve& c, double strain) {
  SofteningCurve carried_on = c;
  carried_on.exp_end = never;
  const auto above_floor = [&](double g) { return strength(carried_on, g) - c.floor; };
  // Beyond 40 e-foldings nothing is left in double precision.
  const double end = c.rate > 0 ? std::min(strain, capped_until(c) + 40 / c.rate) : strain;
  const double flat = std::min(capped_until(c), end);
  return integrate(above_floor, 0, flat, 1) +
         integrate(above_floor, flat, end, c.rate * (end - flat));
}

double line_area(const SofteningCurve& c) {
  return (c.line_start - c.last) * (c.line_end - c.exp_end) / 2;
}

}  // namespace

double dissipation(const SofteningCurve& c, double strain) {
  const double in_exponential = std::min(strain, c.exp_end);
  double area = c.floor * in_exponential + exponential_area(c, in_exponential);
  if (strain > c.exp_end) {
    const double to = std::min(strain, c.line_end);
    area += (c.line_start + strength(c, to)) / 2 * (to - c.exp_end);
  }
  return area + c.last * std::max(0.0, strain - c.line_end);
}

double dissipation_by_quadrature(const SofteningCurve& c, double strain) {
  const double in_exponential = std::min(strain, c.exp_end);
  const auto law = [&](double g) { return strength(c, g); };
  return c.floor * in_exponential + exponential_by_quadrature(c, in_exponential) +
         integrate(law, std::nextafter(c.exp_end, never), std::min(strain, c.line_end), 1) +
         integrate(law, c.line_end, strain, 1);
}

double excess(const SofteningCurve& c) {
  if (c.exp_end == 0) return line_area(c);
  return exponential_area(c, never);
}

double excess_by_quadrature(const SofteningCurve& c) {
  if (c.exp_end > 0) return exponential_by_quadrature(c, never);
  return dissipation_by_quadrature(c, c.line_end) - c.last * c.line_end;
}

double excess_to_residual_strain(const SofteningCurve& c) {
  if (c.exp_end == 0) return excess_by_quadrature(c);
  return exponential_by_quadrature(c, c.exp_end);
}

double steepest_loss(const SofteningCurve& c) {
  const double exponential =
      c.exp_end > 0 ? c.rate * std::min(c.amplitude, std::max(0.0, c.peak - c.floor)) : 0;
  const double width = c.line_end - c.exp_end;
  const double line = width > 0 ? (c.line_start - c.last) / width : 0;
  return std::max(exponential, line);
}

}  // namespace leda::solver
