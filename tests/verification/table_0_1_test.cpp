#include <gtest/gtest.h>

#include "solver/simulate.hpp"

namespace leda::solver::test {
namespace {

// validation cases urmi_slope5m_row02 to row17: thesis, third appendix, Table 0-1, a slope of 5 m
// at 45 degrees; to be used as a test of rank. The section is tests/validation/cases/
// appendix-slope-5m.json: unit weight 17 kN/m3 assumed, and a toe cut of 3 m for every row, since
// the slope stands where gravity comes on gently.
Section slope(double peak_kPa, double remolded_kPa, double eta) {
  Section s;
  s.name = "Table 0-1";
  s.ground = {{0, 5}, {20, 5}, {25, 0}, {55, 0}};
  s.base_m = -0.3;
  s.crest = Point{20, 5};
  s.toe = Point{25, 0};
  s.water_table = WaterTable{0.0, {}};
  Material clay;
  clay.unit_weight = 17e3;
  clay.shear_modulus_Pa = 5e6 / 2.9;
  clay.poisson_ratio = 0.45;
  clay.peak_strength.constant_Pa = 1000 * peak_kPa;
  Material firm = clay;
  firm.peak_strength.constant_Pa = 1e6;
  clay.softening =
      Softening{ExponentialSoftening{1000 * remolded_kPa, eta}, 0.014, Regularization::none};
  s.materials = {{"clay", clay}, {"firm", firm}};
  Layer upper, lower;
  upper.material = "clay";
  upper.bottom_m = 0;
  lower.material = "firm";
  s.layers = {upper, lower};
  return s;
}

SectionResult run(double peak_kPa, double remolded_kPa, double eta) {
  RunSettings settings;
  settings.resolution.cell_m = 0.3;
  settings.stop.max_time_s = 60;
  settings.trigger = UndrainedTrigger{3.0};
  return simulate(slope(peak_kPa, remolded_kPa, eta), settings);
}

void expect_longer(const SectionResult& longer, const SectionResult& shorter) {
  EXPECT_GT(longer.crest_to_crest_retrogression_m, shorter.crest_to_crest_retrogression_m);
  EXPECT_GT(longer.runout_from_crest_m, shorter.runout_from_crest_m);
}

// L_R > 20, 10.8 m; L_O > 35, 24.5 m.
TEST(TableOfTheAppendix, LessRemoldedStrengthGoesFurther) {
  expect_longer(run(30, 1.0, 65), run(30, 3.2, 65));
}

// L_R 17.5, 10.7 m; L_O 26.8, 24.6 m.
TEST(TableOfTheAppendix, LessPeakStrengthGoesFurther) {
  expect_longer(run(19, 2.8, 45), run(28, 2.8, 45));
}

// L_R 4.0, 11.2, 18.4 m; L_O 23.8, 25, 28.0 m.
TEST(TableOfTheAppendix, MoreBrittleClayGoesFurther) {
  const SectionResult slow = run(25, 3.0, 20), middle = run(25, 3.0, 40), fast = run(25, 3.0, 90);
  expect_longer(middle, slow);
  expect_longer(fast, middle);
}

}  // namespace
}  // namespace leda::solver::test
