#include <gtest/gtest.h>

#include <numbers>

#include "tests/solver/block.hpp"
#include "tests/verification/record.hpp"

namespace leda::solver::test {
namespace {

constexpr double density = 1700, g = 9.81, yield_stress = 1000;
constexpr double slope = 6 * std::numbers::pi / 180;

// A layer on a plane, seen along the plane: gravity has a part along it. The stress it starts in is
// that of statics, or of the plug's steady gain of speed where the layer is thicker than its
// strength holds: shear grows evenly with depth in both. Acceleration of the upper half in the
// middle, before waves arrive from the ends.
double acceleration(double thickness, double cell) {
  const double length = 4;
  Block b(cell, length + 4, 2, 2, 0, length, thickness, {5e5, 0.3, density, yield_stress});
  Particles& p = b.particles;
  const double shear_at_base = std::min(density * g * std::sin(slope) * thickness, yield_stress);
  for (std::size_t i = 0; i < p.count; ++i) {
    const double depth = thickness - p.z[i];
    p.sxx[i] = p.szz[i] = p.syy[i] = -density * g * std::cos(slope) * depth;
    p.sxz[i] = -shear_at_base * depth / thickness;
  }
  const double dt = b.time_step();
  const int steps = static_cast<int>(0.05 / dt);
  for (int k = 0; k < steps; ++k) {
    for (std::size_t i = 0; i < p.count; ++i) p.vx[i] -= dt * g * std::sin(slope);
    if (k % 10 == 0) sort_particles(p, b.grid);
    step(p, b.grid, b.laws, {dt, g * std::cos(slope), 0.0, true});
  }
  double momentum = 0, mass = 0;
  for (std::size_t i = 0; i < p.count; ++i) {
    if (std::abs(p.start_x[i] - 2 - length / 2) > 0.5 || p.start_z[i] < thickness / 2) continue;
    momentum += p.mass[i] * p.vx[i];
    mass += p.mass[i];
  }
  return -momentum / mass / (steps * dt);
}

// validation case bingham_uniform_layer_incline: a layer stops where tau_y = rho g h sin(theta),
// h = 0.57365 m for 6 degrees, within 3 %. Above it the plug gains g sin(theta) - tau_y/(rho h).
// The lowest cell hangs on the base's nodes, so the depth found is larger by about 0.8 cells: 3.5 %
// with cells of 0.025 m, half of that with those used here.
TEST(Incline, ALayerStopsAtItsYieldDepth) {
  const double stop = yield_stress / (density * g * std::sin(slope));
  EXPECT_NEAR(stop, 0.57365, 1e-5);
  EXPECT_NEAR(acceleration(0.55, 0.0125), 0, 0.01 * g * std::sin(slope));
  const double thick = 0.70, thicker = 0.80;
  const double a = acceleration(thick, 0.0125), b = acceleration(thicker, 0.0125);
  // a = g sin(theta) (1 - stop / h): each gives a depth at which the layer would stop.
  leda::test::record(thick * (1 - a / (g * std::sin(slope))), " m, ",
                     thicker * (1 - b / (g * std::sin(slope))), " m");
  EXPECT_NEAR(thick * (1 - a / (g * std::sin(slope))), stop, 0.03 * stop);
  EXPECT_NEAR(thicker * (1 - b / (g * std::sin(slope))), stop, 0.03 * stop);
}

}  // namespace
}  // namespace leda::solver::test
