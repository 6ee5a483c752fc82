#include "profiles/zonation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "profiles/areas.hpp"
#include "profiles/map_geometry.hpp"

namespace leda::profiles {
namespace {

// A section across a river along x: crest at y = 40, toe at y = 0, it slides back to y = 40 + R and
// forward to y = -F.
PlacedResult slid(double x, double retrogression, double runout) {
  PlacedResult p;
  p.section = "S" + std::to_string(static_cast<int>(x));
  p.line = 0;
  p.order = x;
  p.known = p.moved = true;
  p.backscarp = {x, 40 + retrogression};
  p.crest = {x, 40};
  p.toe = {x, 0};
  p.front = {x, -runout};
  p.retrogression_m = retrogression;
  p.runout_m = runout;
  p.made_by = "hash of " + p.section;
  return p;
}

PlacedResult stable(double x) {
  PlacedResult p = slid(x, 0, 0);
  p.moved = false;
  p.backscarp = p.front = p.toe;
  return p;
}

PlacedResult missing(double x) {
  PlacedResult p = stable(x);
  p.known = false;
  p.backscarp = p.crest = p.toe = p.front = {x, 20};
  return p;
}

double area(const Zone& zone) {
  const GeometryHandle geometry = to_ogr(zone.area);
  EXPECT_TRUE(geometry->IsValid());
  return geometry->toMultiPolygon()->get_Area();
}

bool covers(const Zone& zone, MapPoint p) {
  return std::any_of(zone.area.begin(), zone.area.end(),
                     [&](const MapPolygon& polygon) { return is_inside(polygon, p); });
}

const Zone& zone_of(const std::vector<Zone>& zones, ZoneKind kind) {
  const auto found =
      std::find_if(zones.begin(), zones.end(), [&](const Zone& z) { return z.kind == kind; });
  EXPECT_NE(found, zones.end());
  return *found;
}

TEST(Zonation, NeighboursAreJoinedAndReachHalfASpacingBeyond) {
  const auto zones = make_zones({slid(0, 60, 20), slid(50, 80, 30), slid(100, 60, 20)});
  ASSERT_EQ(zones.size(), 2U);
  const Zone& release = zone_of(zones, ZoneKind::release);
  const Zone& runout = zone_of(zones, ZoneKind::runout);
  EXPECT_NEAR(area(release), 2 * 50 * 110 + 2 * 25 * 100, 1e-6);
  EXPECT_NEAR(area(runout), 2 * 50 * 25 + 2 * 25 * 20, 1e-6);
  EXPECT_EQ(release.sections, (std::vector<std::string>{"S0", "S50", "S100"}));
  EXPECT_DOUBLE_EQ(release.largest_distance_m, 80);
  EXPECT_NEAR(release.mean_distance_m, 200.0 / 3, 1e-12);
  EXPECT_DOUBLE_EQ(runout.largest_distance_m, 30);
  EXPECT_TRUE(release.warnings.empty());
  EXPECT_EQ(release.made_by.size(), 64U);
  EXPECT_NE(release.made_by, runout.made_by);
  EXPECT_TRUE(covers(release, {50, 119}));
  EXPECT_FALSE(covers(release, {50, -1}));
  EXPECT_TRUE(covers(runout, {50, -1}));
}

TEST(Zonation, OneLowerBoundMakesTheZoneOne) {
  auto results = std::vector{slid(0, 60, 20), slid(50, 80, 30)};
  for (const Zone& zone : make_zones(results)) EXPECT_EQ(zone.distance_is, Bound::measured);
  results[1].runout_is = Bound::lower_bound;
  const auto zones = make_zones(results);
  EXPECT_EQ(zone_of(zones, ZoneKind::release).distance_is, Bound::measured);
  EXPECT_EQ(zone_of(zones, ZoneKind::runout).distance_is, Bound::lower_bound);
}

TEST(Zonation, AWarningOfManySectionsIsToldOnce) {
  std::vector<PlacedResult> results;
  for (int i = 0; i < 5; ++i) {
    results.push_back(slid(50 * i, 60, 20));
    results.back().warnings = {"the front reached the edge"};
  }
  results[1].warnings.emplace_back("alone");
  const auto zones = make_zones(results);
  EXPECT_EQ(
      zones.at(0).warnings,
      (std::vector<std::string>{"S0, S50 and 3 more: the front reached the edge", "S50: alone"}));
  results.resize(2);
  EXPECT_EQ(make_zones(results).at(0).warnings.at(0), "S0, S50: the front reached the edge");
}

TEST(Zonation, TheOrderAlongTheLineDecidesNotTheOrderGiven) {
  auto results = std::vector{slid(100, 60, 20), slid(0, 60, 20), slid(50, 80, 30)};
  const auto zones = make_zones(results);
  std::sort(results.begin(), results.end(),
            [](const auto& a, const auto& b) { return a.order < b.order; });
  const auto sorted = make_zones(results);
  ASSERT_EQ(zones.size(), sorted.size());
  EXPECT_EQ(zones[0].made_by, sorted[0].made_by);
}

TEST(Zonation, WhatMadeAZoneChangesItsHash) {
  auto results = std::vector{slid(0, 60, 20), slid(50, 80, 30)};
  const std::string before = make_zones(results)[0].made_by;
  EXPECT_EQ(make_zones(results)[0].made_by, before);
  results[1].made_by = "another case";
  EXPECT_NE(make_zones(results)[0].made_by, before);
}

TEST(Zonation, TowardsAStableNeighbourItClosesHalfWay) {
  const auto zones = make_zones({slid(0, 60, 20), stable(50), slid(100, 60, 20)});
  ASSERT_EQ(zones.size(), 4U);
  // Half a spacing at the end of the line, and a triangle half-way to the stable section.
  EXPECT_NEAR(area(zone_of(zones, ZoneKind::release)), 25 * 100 + 25 * 100 / 2.0, 1e-6);
  for (const Zone& zone : zones) {
    EXPECT_FALSE(covers(zone, {26, 1}));
    EXPECT_FALSE(covers(zone, {74, 1}));
    EXPECT_TRUE(zone.warnings.empty());
  }
}

// A run that reached its time limit before anything had moved.
TEST(Zonation, TowardsANeighbourThatMayMoveYetItClosesAndSaysSo) {
  PlacedResult unended = stable(50);
  unended.retrogression_is = unended.runout_is = Bound::lower_bound;
  const auto zones = make_zones({slid(0, 60, 20), unended});
  ASSERT_EQ(zones.size(), 2U);
  for (const Zone& zone : zones) {
    EXPECT_EQ(zone.warnings, (std::vector<std::string>{
                                 "S50 moved 0 m, which is a lower bound: the zone closes half-way "
                                 "to it and may reach farther"}));
  }
}

TEST(Zonation, TowardsAMissingNeighbourItEndsHalfWayAndSaysSo) {
  const auto zones = make_zones({slid(0, 60, 20), missing(50), slid(100, 60, 20)});
  ASSERT_EQ(zones.size(), 4U);
  const Zone& release = zone_of(zones, ZoneKind::release);
  EXPECT_NEAR(area(release), 50 * 100, 1e-6);
  EXPECT_TRUE(covers(release, {24, 99}));
  EXPECT_FALSE(covers(release, {26, 50}));
  ASSERT_EQ(release.warnings.size(), 1U);
  EXPECT_NE(release.warnings[0].find("S50 has no result"), std::string::npos);
}

TEST(Zonation, OnlyStableOrMissingSectionsGiveNoZone) {
  EXPECT_TRUE(make_zones({stable(0), missing(50), stable(100)}).empty());
  EXPECT_TRUE(make_zones({}).empty());
}

TEST(Zonation, NeighboursThatSlideToOppositeSidesAreNotJoined) {
  PlacedResult other = slid(50, 60, 20);
  for (MapPoint* p : {&other.backscarp, &other.crest, &other.toe, &other.front}) p->y = -p->y;
  const auto zones = make_zones({slid(0, 60, 20), other});
  ASSERT_EQ(zones.size(), 4U);
  EXPECT_NE(zones[0].warnings.at(0).find("other side"), std::string::npos);
}

// In a sharp bend the lines fan out on one side and cross on the other.
TEST(Zonation, CrossingSectionsGiveValidZones) {
  std::vector<PlacedResult> results;
  for (int i = 0; i < 6; ++i) {
    const double angle = 0.35 * i;
    const auto at = [&](double along) {
      return MapPoint{30 * std::cos(angle) * (1 - along / 30),
                      30 * std::sin(angle) * (1 - along / 30)};
    };
    PlacedResult p = slid(20.0 * i, 0, 0);
    p.toe = at(0);
    p.crest = at(25);
    p.backscarp = at(70 + 15 * (i % 2));
    p.front = at(-20);
    p.retrogression_m = 45 + 15 * (i % 2);
    p.runout_m = 20;
    results.push_back(p);
  }
  const auto zones = make_zones(results);
  ASSERT_EQ(zones.size(), 2U);
  for (const Zone& zone : zones) EXPECT_GT(area(zone), 100);
  for (const PlacedResult& p : results) {
    const MapPoint face{(p.toe.x + p.crest.x) / 2, (p.toe.y + p.crest.y) / 2};
    // Ring edges of the first and last section are borders: look a little inside.
    if (&p == &results.front() || &p == &results.back()) continue;
    EXPECT_TRUE(covers(zone_of(zones, ZoneKind::release), face)) << p.section;
  }
}

TEST(Zonation, ANamedSectionGetsAStrip) {
  PlacedResult named = slid(500, 60, 20);
  named.line = -1;
  const auto zones =
      make_zones({named, slid(0, 60, 20)}, {.metres_per_unit = 1, .strip_width_m = 30});
  ASSERT_EQ(zones.size(), 4U);
  EXPECT_EQ(zones[0].sections, std::vector<std::string>{"S500"});
  EXPECT_NEAR(area(zones[0]), 30 * 100, 1e-6);
  EXPECT_NEAR(area(zones[2]), 30 * 100, 1e-6);  // alone on its line: the same width
}

TEST(Zonation, WidthsAreMetresAlsoWhereTheMapIsInFeet) {
  PlacedResult named = slid(0, 60, 20);
  named.line = -1;
  const auto zones = make_zones({named}, {.metres_per_unit = 0.3048, .strip_width_m = 20});
  EXPECT_NEAR(area(zones[0]), 20 / 0.3048 * 100, 1e-6);
}

TEST(Zonation, RunoutWithoutRetrogressionStillHasTheFaceAsRelease) {
  const auto zones = make_zones({slid(0, 0, 20), slid(50, 0, 0)});
  EXPECT_NEAR(area(zone_of(zones, ZoneKind::release)), 100 * 40, 1e-6);
  EXPECT_NEAR(area(zone_of(zones, ZoneKind::runout)), 25 * 20 + 50 * 20 / 2.0, 1e-6);
}

}  // namespace
}  // namespace leda::profiles
