#include <gtest/gtest.h>

#include "tests/solver/block.hpp"
#include "tests/verification/record.hpp"

namespace leda::solver::test {
namespace {

// validation case column_self_weight_large_strain (Charlton, Coombs and Augarde 2017), nu = 0, at
// the full published load: -rho0 g (l0 - Y) at every point, relative L2 error 2 %. The law in rate
// form shortens the base to exp(-4) of its height; the published one shortens it otherwise, the
// stress is that of statics for both.
double stress_error(double h, int per_side) {
  const double l0 = 50, density = 80, g = 10;
  Block b(h, 2 * h, 52, 0, 0, h, l0, {1e4, 0, density, 1e30}, per_side);
  const double dt = b.time_step(0.3);
  const int ramp = static_cast<int>(40 / dt), hold = static_cast<int>(60 / dt);
  for (int k = 0; k < ramp + hold; ++k) {
    if (k % 10 == 0) sort_particles(b.particles, b.grid);
    step(b.particles, b.grid, b.laws, {dt, g * std::min(1.0, double(k) / ramp), 0.3, true});
  }
  double square = 0, reference = 0;
  for (std::size_t i = 0; i < b.particles.count; ++i) {
    const double exact = -density * g * (l0 - b.particles.start_z[i]);
    square += std::pow(b.particles.szz[i] - exact, 2);
    reference += exact * exact;
  }
  return std::sqrt(square / reference);
}

TEST(Column, FullPublishedLoadKeepsTheStressOfStatics) {
  const double error = stress_error(0.5, 3);
  leda::test::record(100 * error, " % in L2");
  EXPECT_LT(error, 0.02);
}

}  // namespace
}  // namespace leda::solver::test
