#pragma once
// A manufactured motion along the axes and the body force that drives it.

#include <cmath>
#include <numbers>

#include "solver/section/run_settings.hpp"
#include "tests/solver/block.hpp"
#include "tests/verification/drive.hpp"

namespace leda::solver::test {

/// u = A sin(pi X) s(t), v = -A across cos(pi Y) s(t), s = sin(c pi t), c = sqrt(E / rho0), on the
/// unit square. First Piola-Kirchhoff stress P_xx = E ln(Fxx) Fyy, so with F'xx = -pi^2 u and
/// F'yy = -pi^2 v the body force per mass is b_x = pi^2 c^2 u (Fyy / Fxx - 1), b_y likewise.
struct ManufacturedMotion {
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

  /// Body force per mass, m/s2.
  std::pair<double, double> force(double x, double y, double t) const {
    const double stiff = std::pow(std::numbers::pi * c(), 2) * s(t);
    const double fx = 1 + slope_x(x) * s(t), fy = 1 + slope_y(y) * s(t);
    return {stiff * shape_x(x) * (fy / fx - 1), stiff * shape_y(y) * (fx / fy - 1)};
  }

  /// Relative L2 error of the displacement of particles that began at `start`.
  double error(const Particles& now, const Particles& start, double below, double t) const {
    double square = 0, reference = 0;
    for (const Particle& p : now) {
      const Particle& from = start[static_cast<std::size_t>(p.id)];
      const double ux = shape_x(from.x), uy = shape_y(from.z - below);
      square += std::pow(p.x - from.x - ux * s(t), 2) + std::pow(p.z - from.z - uy * s(t), 2);
      reference += ux * ux + uy * uy;
    }
    return std::sqrt(square / reference);
  }
};

/// Largest relative L2 error of the displacement over a quarter of a period.
template <class Real>
double displacement_error(const ManufacturedMotion& m) {
  const double h = 1.0 / m.cells, below = 1;  // metres of nothing under the block
  Block<Real> b(h, 1, 3, 0, below, 1, 1, {m.modulus, 0, m.density, 1e30}, m.per_side);
  b.settings.softer = m.time_step_factor > most_factor_unsoftened;
  const double period = 2 / m.c();
  const int steps = static_cast<int>(std::ceil(0.25 * period / b.time_step(m.time_step_factor)));
  const double dt = 0.25 * period / steps;
  const double start = m.rate(-0.5 * dt);  // velocities live half a step behind positions
  for (Particle& p : b.particles) {
    const double y = p.z - below;
    p.vx = m.shape_x(p.x) * start;
    p.vz = m.shape_y(y) * start;
    p.cxx = m.slope_x(p.x) * start;
    p.czz = m.slope_y(y) * start;
  }
  Model<Real> model = b.model();
  ThreadTeam team(1);
  double largest = 0;
  for (int k = 0; k < steps; ++k) {
    push(model, [&](std::size_t id) {
      const auto [x, z] = m.force(b.start[id].x, b.start[id].z - below, k * dt);
      return std::pair(dt * x, dt * z);
    });
    if (k % 4 == 0) {
      EXPECT_TRUE(tidy_up(model));
    }
    step(model, {dt, 0.0, 0.0, true}, true, team);
    const double off = m.error(unpack(model.packs, h), b.start, below, (k + 1) * dt);
    largest = std::max(largest, off);
  }
  return largest;
}

}  // namespace leda::solver::test
