#include "solver/screening/decide.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/screening/toe_cut.hpp"
#include "tests/screening/banks.hpp"

namespace leda::solver {
namespace {

Section sensitive_bank(double strength_Pa) {
  Section s = test::plane_bank(10, 30, 1.5, test::clay_of(17e3, strength_Pa));
  s.materials["clay"].softening = Softening{ExponentialSoftening{500, 5}};
  s.water_table = WaterTable{0.0, {}};
  return s;
}

RunSettings with_cut(double height_m) {
  RunSettings settings;
  settings.trigger = UndrainedTrigger{height_m};
  return settings;
}

/// The strength at which the worst factor of a ground becomes `wanted`: factors are proportional.
double strength_for(double wanted, const Polyline& ground) {
  const ScreeningMargins m;
  const double factor = *undrained_bishop(sensitive_bank(1), ground);
  return wanted * (1 + m.unit_weight) / (1 - m.strength) / factor;
}

Polyline ground_cut_by(double height_m) {
  const Section unit = sensitive_bank(1);
  return ground_after_toe_cut(unit.ground, *bank_of(unit), height_m);
}

TEST(Decide, AWeakSensitiveBankIsSimulated) {
  const ScreeningResult r = screen(sensitive_bank(40e3), {});
  EXPECT_EQ(r.decision, Decision::simulate);
  EXPECT_TRUE(r.sensitive);
  EXPECT_NE(r.reasons.front().find("intact"), std::string::npos);
}

TEST(Decide, AStrongSensitiveBankIsStable) {
  const ScreeningResult r = screen(sensitive_bank(150e3), {});
  EXPECT_EQ(r.decision, Decision::stable);
  EXPECT_EQ(r.reasons.size(), 2U);
  EXPECT_GE(*r.worst_intact, r.required_intact);
  EXPECT_GE(*r.worst_toe_cut, r.required_toe_cut);
}

TEST(Decide, WorstInputsLowerTheFactorByStrengthAndWeight) {
  const ScreeningResult r = screen(sensitive_bank(60e3), {});
  EXPECT_NEAR(*r.worst_intact, *r.undrained.bishop * 0.90 / 1.03, 1e-12);
  EXPECT_NEAR(*r.worst_toe_cut, *r.undrained_toe_cut.bishop * 0.90 / 1.03, 1e-12);
}

TEST(Decide, TheMarginIsTheBoundary) {
  const ScreeningMargins m;
  const double cut = std::min(m.toe_cut_m, m.toe_cut_share * 10);
  const double limit = strength_for(1 + m.factor, ground_cut_by(cut));
  EXPECT_EQ(screen_quickly(sensitive_bank(1.01 * limit), {}).decision, Decision::stable);
  EXPECT_EQ(screen_quickly(sensitive_bank(0.99 * limit), {}).decision, Decision::simulate);
}

// A strength whose mean is clear of every margin, and whose 5 % fractile is not: exp(-1.645 s -
// s^2/2), 0.593 of the mean at a coefficient of variation of 0.3.
TEST(Decide, ThinksOfTheWeakGroundWhereStrengthVaries) {
  const ScreeningMargins m;
  const double cut = std::min(m.toe_cut_m, m.toe_cut_share * 10);
  const double limit = strength_for(1 + m.factor, ground_cut_by(cut));
  const double weak = std::exp(-1.6448536 * std::sqrt(std::log(1.09)) - std::log(1.09) / 2);
  const auto varying = [&](double strength) {
    Section s = sensitive_bank(strength);
    s.materials["clay"].field = RandomField{0.3, 20, 2};
    return s;
  };
  EXPECT_EQ(screen_quickly(sensitive_bank(1.01 * limit), {}).decision, Decision::stable);
  EXPECT_EQ(screen_quickly(varying(1.01 * limit), {}).decision, Decision::simulate);
  EXPECT_EQ(screen_quickly(varying(0.99 * limit / weak), {}).decision, Decision::simulate);
  EXPECT_EQ(screen_quickly(varying(1.01 * limit / weak), {}).decision, Decision::stable);
}

TEST(Decide, WhatVariesIsScreenedAsItsFractileAndTold) {
  Section varying = sensitive_bank(60e3);
  varying.materials["clay"].field = RandomField{0.3, 20, 2};
  const double weak = std::exp(-1.6448536 * std::sqrt(std::log(1.09)) - std::log(1.09) / 2);
  const ScreeningResult with = screen(varying, {});
  const ScreeningResult without = screen(sensitive_bank(weak * 60e3), {});
  EXPECT_NEAR(*with.worst_intact, *without.worst_intact, 1e-6);
  EXPECT_NEAR(*with.worst_toe_cut, *without.worst_toe_cut, 1e-6);
  EXPECT_NEAR(*with.worst_at_rest, *without.worst_at_rest, 1e-6);
  EXPECT_NEAR(*with.undrained.spencer, *without.undrained.spencer, 1e-4);
  EXPECT_EQ(
      with.reasons.back(),
      "strength varies within the ground: factors are those of its 5 % fractile, clay 0.59 of "
      "its mean");
  EXPECT_EQ(with.reasons.front(), without.reasons.front());
}

TEST(Decide, ACutThatIsAskedForMustBeFurtherFromFailure) {
  const ScreeningMargins m;
  const double limit = strength_for(1 + m.asked_cut_factor, ground_cut_by(2));
  EXPECT_EQ(screen_quickly(sensitive_bank(0.99 * limit), with_cut(2)).decision, Decision::simulate);
  EXPECT_EQ(screen_quickly(sensitive_bank(1.01 * limit), with_cut(2)).decision, Decision::stable);
  EXPECT_EQ(screen_quickly(sensitive_bank(0.99 * limit), {}).decision, Decision::stable);
}

TEST(Decide, ACutHigherThanTheBankIsHeldToIt) {
  EXPECT_NEAR(screen_quickly(sensitive_bank(300e3), with_cut(50)).toe_cut_m, 10, 1e-9);
}

TEST(Decide, WithoutSofteningABankIsStableUnlessItSlips) {
  Section s = sensitive_bank(40e3);
  s.materials["clay"].softening.reset();
  const ScreeningResult stands = screen_quickly(s, {});
  EXPECT_EQ(stands.decision, Decision::stable);
  EXPECT_FALSE(stands.sensitive);
  EXPECT_NE(stands.reasons.front().find("nothing sensitive"), std::string::npos);
  s.materials["clay"].peak_strength.constant_Pa = 15e3;
  EXPECT_EQ(screen_quickly(s, {}).decision, Decision::simulate);
}

TEST(Decide, AMaterialThatNoLayerUsesDoesNotMakeASectionSensitive) {
  Section s = sensitive_bank(40e3);
  s.materials["unused"] = s.materials["clay"];
  s.materials["clay"].softening.reset();
  EXPECT_FALSE(screen_quickly(s, {}).sensitive);
}

TEST(Decide, LevelGroundIsStable) {
  Section s = sensitive_bank(60e3);
  s.ground = {{0, 5}, {100, 5}};
  const ScreeningResult r = screen(s, {});
  EXPECT_EQ(r.decision, Decision::stable);
  EXPECT_FALSE(r.worst_intact);
  EXPECT_EQ(r.toe_cut_m, 0);
  EXPECT_TRUE(r.analytics.missing.contains("analytics"));
}

TEST(Decide, ClayOverstressedAtRestIsSimulated) {
  Section s = sensitive_bank(300e3);
  s.water_table.reset();
  s.materials["clay"].k0 = 0.1;
  s.materials["clay"].peak_strength =
      Strength{Strength::By::depth, 0, {{0, 300e3}, {14, 300e3}, {15, 40e3}}};
  const ScreeningResult r = screen(s, {});
  EXPECT_LT(*r.worst_at_rest, 1);
  EXPECT_EQ(r.decision, Decision::simulate);
  EXPECT_NE(r.reasons.front().find("at rest"), std::string::npos);
}

TEST(Decide, AnExcavationIsAlwaysSimulated) {
  RunSettings settings;
  settings.trigger = ExcavationTrigger{{{80, 0}, {90, 0}, {90, 5}, {80, 5}}};
  EXPECT_EQ(screen(sensitive_bank(500e3), settings).decision, Decision::simulate);
  EXPECT_EQ(screen_quickly(sensitive_bank(500e3), settings).decision, Decision::simulate);
}

// The opposite bank, or any other, may be the one that goes.
TEST(Decide, LooksAtEveryBankOfTheSection) {
  Section s = sensitive_bank(110e3);
  ASSERT_EQ(screen_quickly(s, {}).decision, Decision::stable);
  const Point end = s.ground.back();
  s.ground.push_back({end.x + 2, 22});
  s.ground.push_back({end.x + 60, 22});
  s.crest = s.ground[1];
  s.toe = s.ground[2];
  const ScreeningResult r = screen_quickly(s, {});
  EXPECT_EQ(r.decision, Decision::simulate);
  EXPECT_LT(*r.worst_intact, r.required_intact);
}

TEST(Decide, QuickAndCompleteScreeningAgree) {
  for (int i = 0; i < 15; ++i) {  // 25 to 177 kPa
    const double strength = 25e3 * std::pow(1.15, i);
    const Section s = sensitive_bank(strength);
    for (const RunSettings& settings : {RunSettings{}, with_cut(2)}) {
      const ScreeningResult quick = screen_quickly(s, settings);
      const ScreeningResult complete = screen(s, settings);
      EXPECT_EQ(quick.decision, complete.decision) << strength;
      EXPECT_DOUBLE_EQ(*quick.worst_intact, *complete.worst_intact);
    }
  }
}

TEST(ScreenSite, SainteMoniqueIsSimulated) {
  Site site = test::site_of_row(test::table("thesis_tables_3_3_3_4.csv")[4]);
  site.slope_angle_deg = 24;
  const ScreeningResult r = screen_site(site);
  EXPECT_EQ(r.decision, Decision::simulate);
  EXPECT_TRUE(r.undrained.bishop);
  EXPECT_FALSE(r.drained.bishop);
  EXPECT_FALSE(r.drained.why_not.empty());
}

TEST(ScreenSite, WithoutAnAngleHasNoFactors) {
  const Site site = test::site_of_row(test::table("thesis_tables_3_3_3_4.csv")[4]);
  const ScreeningResult r = screen_site(site);
  EXPECT_EQ(r.decision, Decision::simulate);
  EXPECT_FALSE(r.undrained.bishop);
  EXPECT_NE(r.reasons.front().find("slope angle"), std::string::npos);
}

}  // namespace
}  // namespace leda::solver
