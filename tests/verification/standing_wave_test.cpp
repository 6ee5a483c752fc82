#include <gtest/gtest.h>

#include <numbers>

#include "solver/section/run_settings.hpp"
#include "tests/solver/block.hpp"
#include "tests/verification/record.hpp"

namespace leda::solver::test {
namespace {

template <class Real>
class StandingWave : public ::testing::Test {};
TYPED_TEST_SUITE(StandingWave, BothPrecisions, PrecisionNames);

constexpr double length = 25, v0 = 0.1, wave_number = std::numbers::pi / (2 * length);
constexpr double wave_speed = 10;

// Relative L2 error of the velocity after a quarter and a half of a period.
template <class Real>
double velocity_error(double h, double courant = 0.2) {
  Block<Real> b(h, h, 30, 0, 0, h, length, {100, 0, 1, 1e30});
  b.settings.softer = courant > most_factor_unsoftened;
  const double omega = wave_number * wave_speed;
  const int steps = static_cast<int>(std::round(5.0 / (courant * h / wave_speed)));
  const double dt = 5.0 / steps;
  const double start = std::cos(omega * 0.5 * dt);  // velocities live half a step behind
  for (Particle& p : b.particles) {
    p.vz = v0 * start * std::sin(wave_number * p.z);
    p.czz = v0 * start * wave_number * std::cos(wave_number * p.z);
  }
  b.run(steps, {dt, 0.0, 0.0, true});
  const double now = v0 * std::cos(omega * (5.0 - 0.5 * dt));
  double square = 0, reference = 0;
  for (std::size_t i = 0; i < b.particles.size(); ++i) {
    const double shape = std::sin(wave_number * b.start[i].z);
    square += std::pow(b.particles[i].vz - now * shape, 2);
    reference += std::pow(v0 * shape, 2);
  }
  return std::sqrt(square / reference);
}

struct Errors {
  double coarse, middle, fine;
  double first_order() const { return std::log2(coarse / middle); }
  double second_order() const { return std::log2(middle / fine); }
};

template <class Real>
Errors errors(double courant) {
  const Errors e{velocity_error<Real>(5, courant), velocity_error<Real>(2.5, courant),
                 velocity_error<Real>(1.25, courant)};
  leda::test::record("errors ", e.coarse, ", ", e.middle, ", ", e.fine,
                     " with cells of 5, 2.5, 1.25 m: order ", e.first_order(), ", ",
                     e.second_order());
  return e;
}

// validation case bar_oscillation_1d (Bardenhagen and Kober 2004): the order in the cell, at a
// fixed Courant number. Strains are 1e-2, so the closed form of small strain is itself good to
// about 1e-4 only; the finest mesh stays well above that.
TYPED_TEST(StandingWave, VelocityConvergesWithFirstOrderOrBetter) {
  const Errors e = errors<TypeParam>(0.2);
  EXPECT_GT(e.first_order(), 0.8);
  EXPECT_GT(e.second_order(), 0.8);
}

// The bar's one free end is softer, where a free end has no stress: its order stays.
TYPED_TEST(StandingWave, LongStepsConverge) {
  const Errors e = errors<TypeParam>(0.95);
  EXPECT_GT(e.first_order(), 0.8);
  EXPECT_GT(e.second_order(), 0.8);
}

}  // namespace
}  // namespace leda::solver::test
