#pragma once
// A manufactured motion along the axes and the body force that drives it.

#include <cmath>
#include <numbers>

#include "tests/solver/block.hpp"

namespace leda::solver::test {

/// u = A sin(pi X) s(t), v = -A across cos(pi Y) s(t), s = sin(c pi t), c = sqrt(E / rho0), on the
/// unit square. First Piola-Kirchhoff stress P_xx = E ln(Fxx) Fyy, so with F'xx = -pi^2 u and
/// F'yy = -pi^2 v the body force per mass is b_x = pi^2 c^2 u (Fyy / Fxx - 1), b_y likewise.
struct Manufactured {
  int cells = 8;
  double across = 0;
  int per_side = 2;
  double time_step_factor = 0.2;
  double amplitude = 0.05, modulus = 1e7, density = 1000;

  double c() const { return std::sqrt(modulus / density); }
  double s(double t) const { return std::sin(c() * std::numbers::pi * t); }
  double rate(double t) const {
    return c() * std::numbers::pi * std::cos(c() * std::numbers::pi * t);
  }
  double shape_x(double x) const { return amplitude * std::sin(std::numbers::pi * x); }
  double shape_y(double y) const { return -amplitude * across * std::cos(std::numbers::pi * y); }
  double slope_x(double x) const {
    return amplitude * std::numbers::pi * std::cos(std::numbers::pi * x);
  }
  double slope_y(double y) const {
    return amplitude * across * std::numbers::pi * std::sin(std::numbers::pi * y);
  }
};

/// Largest relative L2 error of the displacement over a quarter of a period.
inline double displacement_error(const Manufactured& m) {
  constexpr double pi = std::numbers::pi;
  const double h = 1.0 / m.cells, below = 1;  // metres of nothing under the block
  Block b(h, 1, 3, 0, below, 1, 1, {m.modulus, 0, m.density, 1e30}, m.per_side);
  Particles& p = b.particles;
  const auto y_of = [&](std::size_t i) { return p.start_z[i] - below; };
  const double period = 2 / m.c();
  const int steps = static_cast<int>(std::ceil(0.25 * period / b.time_step(m.time_step_factor)));
  const double dt = 0.25 * period / steps;
  for (std::size_t i = 0; i < p.count; ++i) {  // velocities live half a step behind positions
    const double start = m.rate(-0.5 * dt);
    p.vx[i] = m.shape_x(p.start_x[i]) * start;
    p.vz[i] = m.shape_y(y_of(i)) * start;
    p.cxx[i] = m.slope_x(p.start_x[i]) * start;
    p.czz[i] = m.slope_y(y_of(i)) * start;
  }
  double largest = 0;
  for (int k = 0; k < steps; ++k) {
    const double s = m.s(k * dt), stiff = pi * pi * m.c() * m.c();
    for (std::size_t i = 0; i < p.count; ++i) {
      const double fx = 1 + m.slope_x(p.start_x[i]) * s, fy = 1 + m.slope_y(y_of(i)) * s;
      p.vx[i] += dt * stiff * m.shape_x(p.start_x[i]) * s * (fy / fx - 1);
      p.vz[i] += dt * stiff * m.shape_y(y_of(i)) * s * (fx / fy - 1);
    }
    if (k % 4 == 0) sort_particles(p, b.grid);
    step(p, b.grid, b.laws, {dt, 0.0, 0.0, true});
    const double now = m.s((k + 1) * dt);
    double square = 0, reference = 0;
    for (std::size_t i = 0; i < p.count; ++i) {
      const double ux = m.shape_x(p.start_x[i]), uy = m.shape_y(y_of(i));
      square += std::pow(p.x[i] - p.start_x[i] - ux * now, 2) +
                std::pow(p.z[i] - p.start_z[i] - uy * now, 2);
      reference += ux * ux + uy * uy;
    }
    largest = std::max(largest, std::sqrt(square / reference));
  }
  return largest;
}

}  // namespace leda::solver::test
