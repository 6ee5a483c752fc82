#include "solver/screening/limit_equilibrium.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/screening/banks.hpp"
#include "tests/verification/record.hpp"

namespace leda::solver {
namespace {

using test::clay_of;
using test::layer_of;
using test::plane_bank;

Material frictional(double unit_weight, double cohesion_Pa, double friction_deg) {
  Material m = clay_of(unit_weight, 50e3);
  m.drained = DrainedStrength{cohesion_Pa, friction_deg};
  return m;
}

double undrained(const Section& s) { return undrained_bishop(s, s.ground).value(); }

FactorsOfSafety drained(const Section& s) {
  return factors_of_safety(s, s.ground, Drainage::drained);
}

Section acads_1a() {
  Section s;
  s.ground = {{20, 25}, {30, 25}, {50, 35}, {70, 35}};
  s.base_m = 20;
  s.materials["soil"] = frictional(20e3, 3e3, 19.6);
  s.layers = {layer_of("soil")};
  return s;
}

// ACADS problem 1(a) (Giam and Donald 1989): referee 1.00, Bishop 0.987, Spencer 0.986.
TEST(LimitEquilibrium, Acads1a) {
  const FactorsOfSafety f = drained(acads_1a());
  EXPECT_NEAR(*f.bishop, 0.987, 0.005);
  EXPECT_NEAR(*f.spencer, 0.986, 0.005);
  EXPECT_NEAR(*f.morgenstern_price, 0.986, 0.005);
  EXPECT_NEAR(*f.bishop, 1.0, 0.02);
  leda::test::record("Bishop ", *f.bishop, ", Spencer ", *f.spencer);
}

// Griffiths and Lane (1999), example 1: 1.4 by finite elements, 1.380 by the charts of Bishop and
// Morgenstern (1960).
TEST(LimitEquilibrium, GriffithsAndLane1) {
  const Section s =
      plane_bank(10, std::atan(0.5) * 180 / std::numbers::pi, 1, frictional(20e3, 10e3, 20));
  const FactorsOfSafety f = drained(s);
  EXPECT_NEAR(*f.bishop, 1.380, 0.01);
  EXPECT_NEAR(*f.spencer, 1.380, 0.01);
  EXPECT_NEAR(*f.morgenstern_price, 1.380, 0.01);
  EXPECT_NEAR(*f.bishop, 1.4, 0.03);
  leda::test::record("Bishop ", *f.bishop, ", Spencer ", *f.spencer);
}

/// Least factor of whole arcs through a dense net of centres and depths: an independent search,
/// with each arc integrated in closed pieces. gamma = H = s_u = 1; the slope falls from (0, 1) to
/// (run, 0).
double brute_force_taylor(double slope_deg, double depth_factor) {
  const double run = 1 / std::tan(slope_deg * std::numbers::pi / 180);
  const auto ground = [&](double x) { return x < 0 ? 1.0 : x > run ? 0.0 : 1 - x / run; };
  double least = 1e9;
  const auto columns = std::lround((2 * run + 0.5) / 0.05),
             depths = std::lround((depth_factor - 0.1) / 0.05);
  for (long column = 0; column <= columns; ++column) {
    const double cx = -0.5 * run + 0.05 * static_cast<double>(column);
    for (int row = 0; row < 50; ++row) {
      const double cz = 1.05 + 0.1 * row;
      for (long down = 0; down <= depths; ++down) {
        const double depth = -0.9 + 0.05 * static_cast<double>(down);
        const double radius = cz + depth;
        double moment = 0;
        double from = 1e9;
        double to = -1e9;
        const int pieces = 400;
        for (int i = 0; i < pieces; ++i) {
          const double x = cx - radius + 2 * radius * (i + 0.5) / pieces;
          const double z = cz - std::sqrt(radius * radius - (x - cx) * (x - cx));
          const double height = ground(x) - z;
          if (height <= 0) continue;
          from = std::min(from, x), to = std::max(to, x);
          moment += height * (cx - x) * 2 * radius / pieces;
        }
        const double half = radius / pieces;
        if (moment < 1e-3 || to - from < 0.3) continue;
        const auto angle = [&](double x) {
          return std::asin(std::clamp((x - cx) / radius, -1.0, 1.0));
        };
        least = std::min(least, radius * radius * (angle(to + half) - angle(from - half)) / moment);
      }
    }
  }
  return least;
}

TEST(LimitEquilibrium, AgreesWithABruteForceSearchOverWholeArcs) {
  for (const auto& [slope, depth] : {std::pair{60.0, 1.5}, {30.0, 1.5}, {30.0, 2.0}, {15.0, 2.0}}) {
    const double found = undrained(plane_bank(1, slope, depth, clay_of(1, 1)));
    const double brute = brute_force_taylor(slope, depth);
    EXPECT_LT(found, 1.005 * brute) << slope << " deg, D " << depth;
    EXPECT_GT(found, 0.96 * brute) << slope << " deg, D " << depth;
  }
}

// Taylor's chart knows whole arcs. On a shallow base under a gentle slope a surface along the base
// is weaker, so that the factor may be lower than the chart's, never higher.
TEST(LimitEquilibrium, TaylorsChart) {
  for (const auto& row : test::table("taylor_1937.csv")) {
    const double chart = 1 / row["stability_number"];
    const double found =
        undrained(plane_bank(1, row["slope_deg"], row["depth_factor"], clay_of(1, 1)));
    const bool along_base = row["slope_deg"] < 20 && row["depth_factor"] < 2.5;
    EXPECT_LT(found, 1.02 * chart) << row["slope_deg"] << " deg, D " << row["depth_factor"];
    EXPECT_GT(found, (along_base ? 0.87 : 0.98) * chart)
        << row["slope_deg"] << " deg, D " << row["depth_factor"];
  }
}

// A vertical cut: 3.831 by slip circles (Taylor 1937), between 3.775 and 3.777 exactly, 4 by wedge.
TEST(LimitEquilibrium, VerticalCut) {
  const double found = undrained(plane_bank(1, 90, 3, clay_of(1, 1)));
  leda::test::record(found);
  EXPECT_NEAR(found, 3.831, 0.005);
  EXPECT_GT(found, 3.775);
}

TEST(LimitEquilibrium, InfiniteSlopeIsStatics) {
  const double found = infinite_slope_undrained(20e3, 17e3, 5, 15 * std::numbers::pi / 180);
  // s_u / (gamma z sin b cos b) = 40 / (17 * 5 * sin 30)
  leda::test::record("off by ", std::abs(found / (40.0 / 42.5) - 1));
  EXPECT_NEAR(found, 40.0 / 42.5, 1e-6);
}

// A long slope on a base parallel to it fails along the base as an endless one does.
TEST(LimitEquilibrium, LongSlopeComesNearTheInfiniteSlope) {
  const double slope = std::tan(15 * std::numbers::pi / 180);
  Section s;
  s.ground = {{0, 300 * slope}, {300, 0}};
  s.base_m = -50;
  s.materials["clay"] = clay_of(17e3, 20e3);
  s.materials["rock"] = clay_of(22e3, 5e6);
  s.layers = {layer_of("clay"), layer_of("rock")};
  s.layers[0].thickness_m = 5;
  const double found = undrained(s);
  EXPECT_GT(found, 0.94118);
  EXPECT_LT(found, 1.06 * 0.94118);
  const auto f = factors_of_safety(s, s.ground, Drainage::undrained);
  EXPECT_TRUE(f.surface->composite);
}

TEST(LimitEquilibrium, EveryMethodAgreesOnFrictionlessArcs) {
  const Section s = plane_bank(10, 40, 2, clay_of(17e3, 30e3));
  const auto f = factors_of_safety(s, s.ground, Drainage::undrained);
  EXPECT_NEAR(*f.spencer, *f.bishop, 1e-3 * *f.bishop);
  EXPECT_NEAR(*f.morgenstern_price, *f.bishop, 1e-3 * *f.bishop);
}

TEST(LimitEquilibrium, SlidesEitherWay) {
  const Section right = plane_bank(10, 35, 1.5, frictional(18e3, 8e3, 25));
  const Section left = test::mirrored(right);
  EXPECT_NEAR(undrained(left), undrained(right), 2e-3 * undrained(right));
  EXPECT_NEAR(*drained(left).bishop, *drained(right).bishop, 2e-3 * *drained(right).bishop);
  EXPECT_NEAR(*drained(left).spencer, *drained(right).spencer, 5e-3 * *drained(right).spencer);
}

// Dividing strength and tan(phi) by the factor must bring the factor to 1.
TEST(LimitEquilibrium, ReducedByItsFactorASlopeIsAtItsLimit) {
  const Section s = plane_bank(10, 30, 1.4, frictional(18e3, 12e3, 22));
  const FactorsOfSafety f = drained(s);
  for (const auto member :
       {&FactorsOfSafety::bishop, &FactorsOfSafety::spencer, &FactorsOfSafety::morgenstern_price}) {
    const double factor = *(f.*member);
    const double reduced =
        std::atan(std::tan(22 * std::numbers::pi / 180) / factor) * 180 / std::numbers::pi;
    const Section limit = plane_bank(10, 30, 1.4, frictional(18e3, 12e3 / factor, reduced));
    EXPECT_NEAR(*(drained(limit).*member), 1, 5e-3);
  }
}

TEST(LimitEquilibrium, WaterLowersTheDrainedFactorOnly) {
  Section s = plane_bank(10, 25, 1.5, frictional(18e3, 5e3, 28));
  const double dry = *drained(s).bishop;
  const double before = undrained(s);
  s.water_table = WaterTable{0.0, {}};
  const double wet = *drained(s).bishop;
  s.water_table = WaterTable{3.0, {}};
  const double between = *drained(s).bishop;
  EXPECT_LT(wet, 0.8 * dry);
  EXPECT_LT(wet, between);
  EXPECT_LT(between, dry);
  EXPECT_DOUBLE_EQ(undrained(s), before);
}

TEST(LimitEquilibrium, WaterAsALineIsTheSameAsADepth) {
  Section s = plane_bank(10, 25, 1.5, frictional(18e3, 5e3, 28));
  s.water_table = WaterTable{0.0, {}};
  const double by_depth = *drained(s).bishop;
  s.water_table = WaterTable{std::nullopt, s.ground};
  EXPECT_NEAR(*drained(s).bishop, by_depth, 1e-9);
}

TEST(LimitEquilibrium, StrengthGrowingWithDepthRaisesTheSurface) {
  Section s = plane_bank(10, 30, 3, clay_of(17e3, 30e3));
  const auto deep = factors_of_safety(s, s.ground, Drainage::undrained);
  Strength& strength = s.materials["clay"].peak_strength;
  strength.by = Strength::By::depth;
  strength.table = {{0, 30e3}, {10, 30e3}, {30, 120e3}};
  const auto shallow = factors_of_safety(s, s.ground, Drainage::undrained);
  EXPECT_GT(*shallow.bishop, *deep.bishop);
  const auto lowest = [](const FactorsOfSafety& f) {
    return std::ranges::min(f.surface->line, {}, &Point::z).z;
  };
  EXPECT_GT(lowest(shallow), lowest(deep) + 1);
}

// A thin soft seam: whole arcs only cross it, a composite surface follows it.
TEST(LimitEquilibrium, FollowsAWeakSeam) {
  Section s = plane_bank(10, 30, 1.5, clay_of(18e3, 60e3));
  s.materials["seam"] = clay_of(18e3, 12e3);
  s.layers = {layer_of("clay"), layer_of("seam"), layer_of("clay")};
  s.layers[0].bottom_m = -0.8;
  s.layers[1].bottom_m = -1.0;
  const auto f = factors_of_safety(s, s.ground, Drainage::undrained);
  EXPECT_TRUE(f.surface->composite);
  EXPECT_LT(*f.bishop, 0.8 * undrained(plane_bank(10, 30, 1.5, clay_of(18e3, 60e3))));
  EXPECT_NEAR(*f.spencer, *f.bishop, 0.12 * *f.bishop);
}

TEST(LimitEquilibrium, ColumnsOfTheSameSoilAreTheSameGround) {
  const Section whole = plane_bank(10, 30, 3, clay_of(17e3, 30e3));
  Section split = whole;
  const double left = whole.ground.front().x, right = whole.ground.back().x;
  split.columns = {{left, 0.4 * left + 0.6 * right, whole.layers},
                   {0.4 * left + 0.6 * right, right, whole.layers}};
  split.layers.clear();
  // An edge of a slice is moved onto the border, which moves the factor by a little.
  EXPECT_NEAR(undrained(split), undrained(whole), 0.003 * undrained(whole));
}

TEST(LimitEquilibrium, OnlyTheSoilWhereTheSurfacePassesCounts) {
  Section s = plane_bank(10, 30, 3, clay_of(17e3, 30e3));
  const double left = s.ground.front().x, right = s.ground.back().x;
  const double whole = undrained(s);
  s.materials["far"] = s.materials.begin()->second;
  s.materials["far"].peak_strength.constant_Pa *= 0.25;
  const std::vector<Layer> layers = s.layers, far{layer_of("far")};
  s.layers.clear();
  s.columns = {{left, left + 1, far}, {left + 1, right, layers}};
  EXPECT_NEAR(undrained(s), whole, 0.003 * whole);
  s.columns = {{left, left + 1, layers}, {left + 1, right, far}};
  EXPECT_NEAR(undrained(s), 0.25 * whole, 0.01 * whole);
}

TEST(LimitEquilibrium, AStrongCrustHelps) {
  Section s = plane_bank(10, 30, 1.5, clay_of(17e3, 30e3));
  const double plain = undrained(s);
  s.materials["crust"] = clay_of(17e3, 90e3);
  s.layers = {layer_of("crust"), layer_of("clay")};
  s.layers[0].thickness_m = 2;
  EXPECT_GT(undrained(s), 1.05 * plain);
}

// A profile from a DEM: a point every metre, each off by up to 0.1 m.
TEST(LimitEquilibrium, RoughnessOfTheGroundChangesLittle) {
  const Section smooth = plane_bank(10, 30, 1.5, clay_of(17e3, 30e3));
  Section rough = smooth;
  rough.ground.clear();
  const double width = smooth.ground.back().x;
  for (int i = 0; i <= static_cast<int>(width); ++i) {
    const double off = 0.1 * std::sin(12.9898 * i) * std::cos(78.233 * i);
    rough.ground.push_back({static_cast<double>(i), elevation_at(smooth.ground, i) + off});
  }
  EXPECT_NEAR(undrained(rough), undrained(smooth), 0.03 * undrained(smooth));
}

TEST(LimitEquilibrium, FlatGroundHasNoFactor) {
  Section s = plane_bank(10, 30, 1.5, clay_of(17e3, 30e3));
  s.ground = {{0, 5}, {100, 5}};
  s.base_m = 0;
  EXPECT_FALSE(undrained_bishop(s, s.ground));
  EXPECT_NE(factors_of_safety(s, s.ground, Drainage::undrained).why_not.find("slope"),
            std::string::npos);
}

TEST(LimitEquilibrium, DrainedNeedsDrainedStrengthOfEveryMaterial) {
  const Section s = plane_bank(10, 30, 1.5, clay_of(17e3, 30e3));
  const FactorsOfSafety f = drained(s);
  EXPECT_FALSE(f.bishop);
  EXPECT_NE(f.why_not.find("clay"), std::string::npos);
}

TEST(LimitEquilibrium, SurfaceEndsOnTheGroundAndStaysAboveTheBase) {
  const Section s = plane_bank(10, 20, 1.2, clay_of(17e3, 30e3));
  const auto f = factors_of_safety(s, s.ground, Drainage::undrained);
  const Polyline& line = f.surface->line;
  EXPECT_NEAR(line.front().z, elevation_at(s.ground, line.front().x), 1e-6);
  EXPECT_NEAR(line.back().z, elevation_at(s.ground, line.back().x), 1e-6);
  for (const Point& p : line) {
    EXPECT_GE(p.z, s.base_m);
    EXPECT_LE(p.z, elevation_at(s.ground, p.x) + 1e-6);
  }
}

}  // namespace
}  // namespace leda::solver
