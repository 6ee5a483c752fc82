// Runs of ground whose strength varies: the field on particles, the quiet stages, what is told.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "solver/run/initial_stress.hpp"
#include "solver/run/simulate.hpp"
#include "solver/screening/decide.hpp"
#include "tests/solver/bank.hpp"

namespace leda::solver::test {
namespace {

Section varying_bank(double strength, double cov = 0.3) {
  Section s = bank(10, 30, strength);
  s.materials["clay"].field = RandomField{cov, 20, 2};
  return s;
}

// Strengths by place, in whole millimetres.
std::map<std::pair<long, long>, double> strengths(const Section& section, const Resolution& at) {
  const Seeded seeded = seed_particles(section, at);
  std::map<std::pair<long, long>, double> found;
  for (const Particle& p : seeded.particles) {
    found[{std::lround(p.x * 1000), std::lround(p.z * 1000)}] =
        seeded.laws.peak[static_cast<std::size_t>(p.law)];
  }
  return found;
}

TEST(StrengthInSpace, IsTheSameFieldUnderOtherCells) {
  Section s = varying_bank(25e3);
  s.ground = {{0, 10}, {39, 10}, {60, 0}, {90, 0}};  // 60 cells of the coarse ones
  const auto coarse_ones = strengths(s, {1.5, 1, 3}), fine_ones = strengths(s, {0.5, 1, 3});
  ASSERT_GT(coarse_ones.size(), 200U);
  for (const auto& [place, strength] : coarse_ones) {
    ASSERT_TRUE(fine_ones.contains(place));
    EXPECT_EQ(fine_ones.at(place), strength);
  }
}

TEST(StrengthInSpace, DoesNotDependOnOtherMaterialsAndDiffersBySeed) {
  const Section s = varying_bank(25e3);
  Section more = s;
  more.materials["another"] = s.materials.at("clay");
  EXPECT_EQ(strengths(s, {1, 4, 3}), strengths(more, {1, 4, 3}));
  EXPECT_EQ(strengths(s, {1, 4, 0}), strengths(s, {1, 4, 0}));
  EXPECT_NE(strengths(s, {1, 4, 0}), strengths(s, {1, 4, 3}));
}

TEST(StrengthInSpace, MultipliesAStrengthThatGrowsWithDepth) {
  Section s = varying_bank(25e3), by_depth = s;
  by_depth.materials["clay"].peak_strength = {Strength::By::elevation, 0, {{-3, 50e3}, {10, 25e3}}};
  const auto constant = strengths(s, {1, 4, 3}), grown = strengths(by_depth, {1, 4, 3});
  // Each is rounded to an eighth of the standard deviation of the logarithm.
  const double rounding = 2 * std::sqrt(std::log1p(0.09)) / 8;
  for (const auto& [place, strength] : constant) {
    const double z = static_cast<double>(place.second) / 1000 - 3;
    const double expected = strength * (50 - (z + 3) / 13 * 25) / 25;
    EXPECT_NEAR(std::log(grown.at(place) / expected), 0, rounding + 1e-6);
  }
}

// Stress begins as K0 has it and is brought to balance within the strength of every place: what
// begins beyond it yields in the quiet stage, without softening.
TEST(StrengthInSpace, TheQuietStagesEndWithinTheStrengthOfEachPlace) {
  const Section section = varying_bank(30e3);
  const RunSettings settings = coarse();
  const Listener listener;
  RunState run;
  run.section = &section;
  run.settings = &settings;
  run.listener = &listener;
  run.seeded = seed_particles(section, settings.resolution);
  begin_quiet(run);
  ASSERT_FALSE(find_initial_stress(run));
  EXPECT_TRUE(run.warnings.empty()) << run.warnings.front();
  double at_yield = 0;
  for (const Particle& p : particles_of(run.model)) {
    const double strength = run.seeded.laws.peak[static_cast<std::size_t>(p.law)];
    const double radius = std::hypot((p.sxx - p.szz) / 2, p.sxz);
    EXPECT_LE(radius, strength * (1 + 1e-6));
    EXPECT_EQ(p.plastic_strain, 0);
    at_yield += radius > 0.999 * strength ? 1 : 0;
  }
  EXPECT_GT(at_yield, 0) << "weak places yield, which is what is looked at";
}

TEST(StrengthInSpace, OfNoVariationIsTheRunWithoutIt) {
  RunSettings settings = coarse();
  settings.stop.max_time_s = 5;
  const SectionResult with = simulate(varying_bank(25e3, 1e-9), settings);
  const SectionResult without = simulate(bank(10, 30, 25e3), settings);
  EXPECT_EQ(with.steps, without.steps);
  EXPECT_EQ(with.crest_to_crest_retrogression_m, without.crest_to_crest_retrogression_m);
  EXPECT_EQ(with.profile_after, without.profile_after);
}

TEST(StrengthInSpace, IsToldWithTheResult) {
  RunSettings settings = coarse();
  settings.stop.max_time_s = 0.5;
  const SectionResult r = simulate(varying_bank(25e3), settings);
  const auto told = std::ranges::find_if(r.warnings, [](const std::string& warning) {
    return warning.starts_with("strength of clay varies within the ground (cov 0.3): 0.");
  });
  ASSERT_NE(told, r.warnings.end());
  EXPECT_NE(told->find(" of " + std::to_string(r.particles) + " particles"), std::string::npos);
}

TEST(StrengthInSpace, MakesDistancesOfSeedsScatter) {
  RunSettings settings = coarse();
  settings.stop.max_time_s = 8;
  std::set<double> of_field, of_lattice;
  for (settings.resolution.seed = 1; settings.resolution.seed <= 4; ++settings.resolution.seed) {
    of_field.insert(simulate(varying_bank(60e3), settings).crest_to_crest_retrogression_m);
    of_lattice.insert(simulate(bank(10, 30, 60e3), settings).crest_to_crest_retrogression_m);
  }
  EXPECT_EQ(of_lattice, std::set<double>{0});
  EXPECT_GE(of_field.size(), 3U);
  EXPECT_GT(*of_field.rbegin() - *of_field.begin(), 10);
}

// What screening would skip for its mean moves where its strength varies: it goes by weak ground.
TEST(StrengthInSpace, ThatMakesASafeMeanMoveIsNotSkippedByScreening) {
  RunSettings settings = coarse();
  settings.stop.max_time_s = 4;
  settings.resolution.seed = 1;
  EXPECT_EQ(screen_quickly(bank(10, 30, 60e3), settings).decision, Decision::stable);
  EXPECT_EQ(simulate(bank(10, 30, 60e3), settings).status, RunStatus::stable);
  EXPECT_EQ(screen_quickly(varying_bank(60e3), settings).decision, Decision::simulate);
  EXPECT_NE(simulate(varying_bank(60e3), settings).status, RunStatus::stable);
}

std::string interrupted_state(const Section& section, const RunSettings& settings, int looks) {
  std::string kept;
  int count = 0;
  Listener listener;
  listener.progress = [&](const Progress& p) { count += p.time_s > 0 ? 1 : 0; };
  listener.interrupted = [&] { return count >= looks; };
  listener.checkpoint = [&](const std::string& state, std::int64_t) { kept = state; };
  listener.checkpoint_interval_s = 1e9;
  EXPECT_EQ(simulate(section, settings, listener).status, RunStatus::interrupted);
  return kept;
}

TEST(StrengthInSpace, AResumedRunGivesTheSameBytes) {
  const Section section = varying_bank(25e3);
  RunSettings settings = coarse();
  settings.stop.max_time_s = 6;
  settings.resolution.seed = 5;
  const SectionResult whole = simulate(section, settings);
  bool taken_up = false;
  Listener listener;
  listener.resume_from = interrupted_state(section, settings, 9);
  listener.resumed = [&](bool taken) { taken_up = taken; };
  const SectionResult resumed = simulate(section, settings, listener);
  EXPECT_TRUE(taken_up);
  EXPECT_EQ(resumed.steps, whole.steps);
  EXPECT_EQ(resumed.profile_after, whole.profile_after);
  EXPECT_EQ(resumed.balances.energy, whole.balances.energy);
  EXPECT_EQ(resumed.warnings, whole.warnings);
}

}  // namespace
}  // namespace leda::solver::test
