#include "solver/section/material.hpp"

#include <gtest/gtest.h>

namespace leda {
namespace {

TEST(Strength, ConstantIsTheSameEverywhere) {
  Strength s;
  s.constant_Pa = 40e3;
  EXPECT_DOUBLE_EQ(s.at(3, 17), 40e3);
  EXPECT_DOUBLE_EQ(s.smallest(), 40e3);
  EXPECT_DOUBLE_EQ(s.largest(), 40e3);
}

TEST(Strength, TableOverDepthIsStraightBetweenRowsAndHeldBeyond) {
  const Strength s{Strength::By::depth, 0, {{2, 25e3}, {10, 25e3}, {20, 50e3}}};
  EXPECT_DOUBLE_EQ(s.at(0, 100), 25e3);
  EXPECT_DOUBLE_EQ(s.at(6, 100), 25e3);
  EXPECT_DOUBLE_EQ(s.at(15, 100), 37.5e3);
  EXPECT_DOUBLE_EQ(s.at(20, 100), 50e3);
  EXPECT_DOUBLE_EQ(s.at(99, 100), 50e3);
  EXPECT_DOUBLE_EQ(s.smallest(), 25e3);
  EXPECT_DOUBLE_EQ(s.largest(), 50e3);
}

TEST(Strength, TableOverElevationLooksAtElevation) {
  const Strength s{Strength::By::elevation, 0, {{0, 60e3}, {20, 20e3}}};
  EXPECT_DOUBLE_EQ(s.at(15, 5), 50e3);
  EXPECT_DOUBLE_EQ(s.smallest(), 20e3);
}

TEST(Material, YoungsModulusFollowsFromShearModulus) {
  Material m;
  m.shear_modulus_Pa = 1e6;
  m.poisson_ratio = 0.45;
  EXPECT_DOUBLE_EQ(m.youngs_modulus_Pa(), 2.9e6);
}

}  // namespace
}  // namespace leda
