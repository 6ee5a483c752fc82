#include "profiles/place_result.hpp"

#include <gtest/gtest.h>

namespace leda::profiles {
namespace {

Profile profile() {
  Profile p;
  p.section = "S001";
  p.trace = {{1000, 2000}, {1000, 1694}};
  p.ground = {{0, 21.7}, {183, 21.7}, {220, 5}, {306, 5}};
  p.bank = {{183, 21.7}, {220, 5}};
  p.warnings = {"shortened"};
  return p;
}

SectionResult slid() {
  SectionResult r;
  r.status = RunStatus::at_rest;
  r.crest_to_crest_retrogression_m = 100;
  r.runout_m = 20;
  r.backscarp = {83, 21.7};
  r.front = {240, 7};
  r.warnings = {"front near the edge"};
  return r;
}

TEST(PlaceResult, PointsLieOnTheTrace) {
  const PlacedResult placed = place_result(profile(), 2, 75, slid(), "hash");
  EXPECT_TRUE(placed.known && placed.moved);
  EXPECT_EQ(placed.line, 2);
  EXPECT_DOUBLE_EQ(placed.order, 75);
  EXPECT_NEAR(placed.backscarp.y, 1917, 1e-9);
  EXPECT_NEAR(placed.crest.y, 1817, 1e-9);
  EXPECT_NEAR(placed.toe.y, 1780, 1e-9);
  EXPECT_NEAR(placed.front.y, 1760, 1e-9);
  EXPECT_DOUBLE_EQ(placed.front.x, 1000);
  EXPECT_EQ(placed.warnings, (std::vector<std::string>{"front near the edge", "shortened"}));
  EXPECT_EQ(placed.made_by, "hash");
}

TEST(PlaceResult, AMapInFeetNeedsNoUnit) {
  Profile feet = profile();
  feet.trace = {{0, 0}, {306 / 0.3048, 0}};
  EXPECT_NEAR(place_result(feet, 0, 0, slid(), "").crest.x, 183 / 0.3048, 1e-6);
}

TEST(PlaceResult, AnUnstableRunIsNotKnown) {
  SectionResult result = slid();
  result.status = RunStatus::unstable;
  result.reason = "energy audit";
  const PlacedResult placed = place_result(profile(), 0, 0, result, "");
  EXPECT_FALSE(placed.known);
  EXPECT_NE(placed.warnings.back().find("energy audit"), std::string::npos);
}

TEST(PlaceResult, AStableSectionStaysWhereItIs) {
  const PlacedResult placed = place_stable(profile(), 0, 0, "hash");
  EXPECT_TRUE(placed.known);
  EXPECT_FALSE(placed.moved);
  EXPECT_EQ(placed.backscarp, placed.toe);
  EXPECT_EQ(placed.front, placed.toe);
}

TEST(PlaceResult, AFrontBeyondTheEndIsHeldAndSaid) {
  SectionResult result = slid();
  result.front = {400, 5};
  const PlacedResult placed = place_result(profile(), 0, 0, result, "");
  EXPECT_EQ(placed.front, (MapPoint{1000, 1694}));
  EXPECT_NE(placed.warnings.back().find("beyond the end"), std::string::npos);
}

TEST(PlaceResult, ASectionWithoutAResultKeepsItsReason) {
  const PlacedResult placed = place_unknown("S002", profile().trace, 1, 50, "no data");
  EXPECT_FALSE(placed.known);
  EXPECT_EQ(placed.toe, (MapPoint{1000, 1847}));
  EXPECT_EQ(placed.warnings, (std::vector<std::string>{"no data"}));
}

}  // namespace
}  // namespace leda::profiles
