#include "solver/section/shear_at_rest.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "solver/section/warnings.hpp"
#include "tests/section/bank.hpp"

namespace leda {
namespace {

/// Level ground of 20 m of clay of 16 kN/m3 and 40 kPa, dry.
Section level_ground() {
  Section s = test::bank();
  s.ground = {{0, 20}, {100, 20}};
  s.water_table.reset();
  s.layers = {test::layer("clay")};
  s.materials.at("clay").unit_weight = 16e3;
  s.materials.at("clay").k0 = 0.5;
  return s;
}

// tau = (1 - K0) gamma z / 2 = 4 z kPa reaches 40 kPa at 10 m: half of the ground lies deeper.
TEST(ShearAtRest, ShareBeyondStrengthOfLevelGroundIsTheClosedForm) {
  Section s = level_ground();
  EXPECT_NEAR(share_beyond_strength_at_rest(s), 0.5, 0.05);
  s.materials.at("clay").peak_strength.constant_Pa = 60e3;
  EXPECT_NEAR(share_beyond_strength_at_rest(s), 0.25, 0.05);
  s.water_table = WaterTable{0.0, {}};
  EXPECT_DOUBLE_EQ(share_beyond_strength_at_rest(s), 0) << "(16 - 9.81) / 4 kPa a metre";
}

bool tells_of_k0(const Section& section) {
  return std::ranges::any_of(warnings_of(section, {}), [](const std::string& warning) {
    return warning.find("k0 acts on the total stress") != std::string::npos;
  });
}

TEST(ShearAtRest, DryGroundMostlyBeyondItsStrengthIsTold) {
  Section s = test::bank();
  s.materials.at("clay").peak_strength.constant_Pa = 15e3;
  s.materials.at("clay2").peak_strength.constant_Pa = 15e3;
  EXPECT_FALSE(tells_of_k0(s)) << "water carries it";
  s.water_table.reset();
  EXPECT_TRUE(tells_of_k0(s));
  s.water_table = WaterTable{50.0, {}};
  EXPECT_TRUE(tells_of_k0(s)) << "a water table below the base is none";
  for (auto& [name, material] : s.materials) material.k0 = 0.95;
  EXPECT_FALSE(tells_of_k0(s));
}

}  // namespace
}  // namespace leda
