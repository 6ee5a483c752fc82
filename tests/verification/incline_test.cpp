#include <gtest/gtest.h>

#include <numbers>

#include "solver/section/run_settings.hpp"
#include "tests/solver/block.hpp"
#include "tests/verification/drive.hpp"
#include "tests/verification/record.hpp"

namespace leda::solver::test {
namespace {

template <class Real>
class Incline : public ::testing::Test {};
TYPED_TEST_SUITE(Incline, BothPrecisions, PrecisionNames);

constexpr double density = 1700, g = 9.81, yield_stress = 1000;
constexpr double slope = 6 * std::numbers::pi / 180;
const double along = g * std::sin(slope);
const double stop = yield_stress / (density * along);

// A layer on a plane, seen along the plane: gravity has a part along it. The stress it starts in is
// that of statics, or of the plug's steady gain of speed where the layer is thicker than its
// strength holds: shear grows evenly with depth in both. Acceleration of the upper half in the
// middle, before waves arrive from the ends.
template <class Real>
double acceleration(double thickness, double cell, double time_step_factor = 0.4) {
  const double length = 4;
  Block<Real> b(cell, length + 4, 2, 2, 0, length, thickness, {5e5, 0.3, density, yield_stress});
  b.settings.softer = time_step_factor > most_factor_unsoftened;
  const double shear_at_base = std::min(density * along * thickness, yield_stress);
  for (Particle& p : b.particles) {
    const double depth = thickness - p.z;
    p.sxx = p.szz = p.syy = -density * g * std::cos(slope) * depth;
    p.sxz = -shear_at_base * depth / thickness;
  }
  Model<Real> model = b.model();
  ThreadTeam team(1);
  const double dt = b.time_step(time_step_factor);
  const int steps = static_cast<int>(0.05 / dt);
  for (int k = 0; k < steps; ++k) {
    push(model, [&](std::size_t) { return std::pair(-dt * along, 0.0); });
    if (k % 10 == 0) {
      EXPECT_TRUE(tidy_up(model));
    }
    step(model, {dt, g * std::cos(slope), 0.0, true}, true, team);
  }
  double momentum = 0, mass = 0;
  for (const Particle& p : unpack(model.packs, cell)) {
    const Particle& start = b.start[static_cast<std::size_t>(p.id)];
    if (std::abs(start.x - 2 - length / 2) > 0.5 || start.z < thickness / 2) continue;
    momentum += p.mass * p.vx;
    mass += p.mass;
  }
  return -momentum / mass / (steps * dt);
}

// The depth at which a layer of this acceleration would stop: a = g sin(theta) (1 - stop / h).
double stops_at(double thickness, double acceleration) {
  return thickness * (1 - acceleration / along);
}

// validation case bingham_uniform_layer_incline: a layer stops where tau_y = rho g h sin(theta),
// h = 0.57365 m for 6 degrees, within 3 %. Above it the plug gains g sin(theta) - tau_y/(rho h).
// The lowest cell hangs on the base's nodes, so the depth found is larger by about 0.8 cells: 3.5 %
// with cells of 0.025 m, half of that with those used here.
TYPED_TEST(Incline, ALayerStopsAtItsYieldDepth) {
  EXPECT_NEAR(stop, 0.57365, 1e-5);
  EXPECT_NEAR(acceleration<TypeParam>(0.55, 0.0125), 0, 0.01 * along);
  const double first = stops_at(0.70, acceleration<TypeParam>(0.70, 0.0125));
  const double second = stops_at(0.80, acceleration<TypeParam>(0.80, 0.0125));
  leda::test::record(first, " m, ", second, " m");
  EXPECT_NEAR(first, stop, 0.03 * stop);
  EXPECT_NEAR(second, stop, 0.03 * stop);
}

TYPED_TEST(Incline, LongStepsStopTheLayerAtTheSameDepth) {
  const double resting = acceleration<TypeParam>(0.55, 0.0125, 0.95);
  const double first = stops_at(0.70, acceleration<TypeParam>(0.70, 0.0125, 0.95));
  const double second = stops_at(0.80, acceleration<TypeParam>(0.80, 0.0125, 0.95));
  leda::test::record(first, " m, ", second, " m; below it ", resting / along, " g sin(theta)");
  EXPECT_NEAR(resting, 0, 0.01 * along);
  EXPECT_NEAR(first, stop, 0.03 * stop);
  EXPECT_NEAR(second, stop, 0.03 * stop);
}

}  // namespace
}  // namespace leda::solver::test
