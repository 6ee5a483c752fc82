#include <gtest/gtest.h>

#include <numbers>

#include "tests/solver/block.hpp"
#include "tests/verification/record.hpp"

namespace leda::solver::test {
namespace {

constexpr double length = 25, v0 = 0.1, wave_number = std::numbers::pi / (2 * length);

// Relative L2 error of the velocity after a quarter and a half of a period.
double velocity_error(double h) {
  Block b(h, h, 30, 0, 0, h, length, {100, 0, 1, 1e30});
  Particles& p = b.particles;
  const double omega = wave_number * std::sqrt(100.0);
  const int steps = static_cast<int>(std::round(5.0 / (0.02 * h)));
  const double dt = 5.0 / steps;
  const double start = std::cos(omega * 0.5 * dt);  // velocities live half a step behind
  for (std::size_t i = 0; i < p.count; ++i) {
    p.vz[i] = v0 * start * std::sin(wave_number * p.z[i]);
    p.czz[i] = v0 * start * wave_number * std::cos(wave_number * p.z[i]);
  }
  b.run(steps, {dt, 0.0, 0.0, true});
  const double now = v0 * std::cos(omega * (5.0 - 0.5 * dt));
  double square = 0, reference = 0;
  for (std::size_t i = 0; i < p.count; ++i) {
    const double shape = std::sin(wave_number * p.start_z[i]);
    square += std::pow(p.vz[i] - now * shape, 2);
    reference += std::pow(v0 * shape, 2);
  }
  return std::sqrt(square / reference);
}

// validation case bar_oscillation_1d (Bardenhagen and Kober 2004): the order in the cell, at a
// fixed Courant number. Strains are 1e-2, so the closed form of small strain is itself good to
// about 1e-4 only; the finest mesh stays well above that.
TEST(StandingWave, VelocityConvergesWithFirstOrderOrBetter) {
  const double coarse = velocity_error(5), middle = velocity_error(2.5),
               fine = velocity_error(1.25);
  leda::test::record("errors ", coarse, ", ", middle, ", ", fine,
                     " with cells of 5, 2.5, 1.25 m: order ", std::log2(coarse / middle), ", ",
                     std::log2(middle / fine));
  EXPECT_GT(std::log2(coarse / middle), 0.8);
  EXPECT_GT(std::log2(middle / fine), 0.8);
}

}  // namespace
}  // namespace leda::solver::test
