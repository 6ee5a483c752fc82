#include <gtest/gtest.h>

#include <cmath>

#include "solver/run/simulate.hpp"
#include "tests/verification/precision.hpp"
#include "tests/verification/record.hpp"

namespace leda::solver::test {
namespace {

// validation case delcastillo2026_slope5m_undrained (Del Castillo, Borja and Favero Neto 2026,
// smoothed particles): 5 m at 45 degrees, toe 25 m from the wall, rho = 2150 kg/m3, cohesion 15.1
// to 1.5 kPa with eta = 5. Their nearly incompressible water (200 MPa at a porosity of 0.4) on a
// skeleton of E = 25 MPa and nu = 0.3 is an undrained Poisson's ratio of 0.49. Their strain is
// sqrt(2/3 e:e), the engineering shear strain sqrt(3) times that: eta = 5 / sqrt(3) here.
// Of the published numbers L = 21.6 m and R = 14.0 m are held to the 25 % of the case's file, the
// band of one code against another. The cell is 0.1 m, the distance of their particles: nothing
// spreads the softening over a length, so the width of a band is the cell's, and coarser cells let
// fewer blocks come off (README.md, "Other cells and ratios").
Section slope() {
  Section s;
  s.name = "Del Castillo et al. 2026";
  s.ground = {{0, 5}, {20, 5}, {25, 0}, {60, 0}};
  s.base_m = -0.25;
  s.crest = Point{20, 5};
  s.toe = Point{25, 0};
  s.water_table = WaterTable{0.0, {}};
  Material clay;
  clay.unit_weight = 2150 * gravity;
  clay.shear_modulus_Pa = 25e6 / 2.6;
  clay.poisson_ratio = 0.49;
  clay.peak_strength.constant_Pa = 15.1e3;
  Material firm = clay;
  firm.peak_strength.constant_Pa = 1e6;
  clay.softening =
      Softening{ExponentialSoftening{1.5e3, 5 / std::sqrt(3.0)}, 0.1, Regularization::none};
  s.materials = {{"clay", clay}, {"firm", firm}};
  Layer upper, lower;
  upper.material = "clay";
  upper.bottom_m = 0;
  lower.material = "firm";
  s.layers = {upper, lower};
  return s;
}

template <class Real>
class DelCastillo : public ::testing::Test {};
TYPED_TEST_SUITE(DelCastillo, BothPrecisions, PrecisionNames);

TYPED_TEST(DelCastillo, RunoutAndRetrogressionOfTheirSlope) {
  RunSettings settings = settings_in<TypeParam>();
  settings.resolution.cell_m = 0.1;
  settings.stop.max_time_s = 20;
  const SectionResult r = simulate(slope(), settings);
  leda::test::record("L ", r.runout_m, " m, R ", r.crest_to_crest_retrogression_m, " m, slides ",
                     r.slides);
  EXPECT_NEAR(r.runout_m, 21.6, 0.25 * 21.6);
  EXPECT_NEAR(r.crest_to_crest_retrogression_m, 14.0, 0.25 * 14.0);
}

}  // namespace
}  // namespace leda::solver::test
