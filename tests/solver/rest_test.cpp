// Ground at rest: when it rests and wakes, and that a run with it answers as one without.
#include "solver/kernel/rest.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/run/checkpoint.hpp"
#include "solver/run/simulate.hpp"
#include "tests/solver/bank.hpp"

namespace leda::solver::test {
namespace {

constexpr double dt = 0.01, width = 16;

std::vector<PointSums> speeds(const std::vector<double>& speed) {
  std::vector<PointSums> sums(speed.size());
  for (std::size_t i = 0; i < speed.size(); ++i) {
    sums[i].fastest_squared = speed[i] * speed[i];
  }
  return sums;
}

std::vector<GroupRest> after_steps(std::size_t groups, const std::vector<PointSums>& sums,
                                   int count) {
  std::vector<GroupRest> rest(groups);
  for (int i = 0; i < count; ++i) observe(rest, sums, dt, width);
  decide(rest, width);
  return rest;
}

std::string resting(const std::vector<GroupRest>& rest) {
  std::string text;
  for (const GroupRest& g : rest) text += g.rests ? 'r' : '-';
  return text;
}

TEST(Rest, AQuietGroupStaysAwakeBesideAMovingOne) {
  const auto sums = speeds({1.0, 0.001, 0.001, 0.001});
  EXPECT_EQ(resting(after_steps(4, sums, 49)), "----");
  EXPECT_EQ(resting(after_steps(4, sums, 51)), "--rr");
}

TEST(Rest, GroundThatYieldsIsAwakeAndItsNeighbourToo) {
  auto sums = speeds({0.001, 0.001, 0.001, 0.001});
  sums[3].yields = true;
  EXPECT_EQ(resting(after_steps(4, sums, 60)), "rr--");
}

TEST(Rest, WakesWhenTheNeighbourIsFastOrYields) {
  const auto quiet = speeds({0.001, 0.001, 0.001, 0.001});
  auto fast = quiet, yielding = quiet;
  fast[1] = speeds({0.03})[0];
  yielding[1].yields = true;
  for (const auto& next : {fast, yielding}) {
    auto rest = after_steps(4, speeds({1.0, 0.001, 0.001, 0.001}), 60);
    ASSERT_EQ(resting(rest), "--rr");
    EXPECT_FALSE(observe(rest, quiet, dt, width));
    EXPECT_TRUE(observe(rest, next, dt, width));
    EXPECT_TRUE(decide(rest, width));
    EXPECT_EQ(resting(rest), "---r");
  }
}

TEST(Rest, WakesWhenTheNeighbourHasCreptAThousandthOfTheWidth) {
  auto rest = after_steps(3, speeds({1.0, 0.001, 0.001}), 60);
  ASSERT_EQ(resting(rest), "--r");
  int steps = 1;
  while (!observe(rest, speeds({0.0, 0.016, 0.0}), dt, width)) ++steps;
  EXPECT_NEAR(steps, 1e-3 * width / (0.016 * dt), 1);
}

// A bank in a plain, parts of which have nothing to do; its clay is too strong to run away.
Section in_a_plain() {
  Section s = bank(10, 30, 25e3);
  s.materials["clay"].softening =
      Softening{ExponentialSoftening{10e3, 5}, 0.014, Regularization::none};
  for (Point& p : s.ground) p.x += 160;
  s.ground.front().x = 0;
  s.ground.back().x += 100;
  return s;
}

double share_stepped(const SectionResult& r) {
  const double particle_steps = static_cast<double>(r.particles) * static_cast<double>(r.steps);
  return r.run_time_s * 1e9 / r.ns_per_particle_step / particle_steps;
}

// Within one cell, with four fifths of the work.
TEST(Rest, RetrogressionIsThatOfARunWithoutIt) {
  RunSettings settings = coarse();
  const SectionResult saving = simulate(in_a_plain(), settings);
  settings.ground_rests = false;
  const SectionResult full = simulate(in_a_plain(), settings);
  ASSERT_GT(full.crest_to_crest_retrogression_m, 5);
  EXPECT_NEAR(saving.crest_to_crest_retrogression_m, full.crest_to_crest_retrogression_m,
              settings.resolution.cell_m);
  EXPECT_NEAR(saving.runout_m, full.runout_m, settings.resolution.cell_m);
  EXPECT_NEAR(share_stepped(full), 1, 1e-9);
  EXPECT_LT(share_stepped(saving), 0.9);
  EXPECT_LT(saving.balances.mass, 1e-6);
  EXPECT_LT(saving.balances.momentum, 1e-6);
  EXPECT_NEAR(saving.balances.energy, full.balances.energy, 0.005);
}

TEST(Rest, AResumedRunGivesTheSameBytes) {
  RunSettings settings = coarse();
  settings.stop.max_time_s = 6;
  Listener listener;
  Frame whole, resumed;
  listener.frame = [&](const Frame& f) { whole = f; };
  ASSERT_LT(share_stepped(simulate(in_a_plain(), settings, listener)), 0.95);
  int looks = 0;
  Listener first;
  first.progress = [&](const Progress& p) { looks += p.time_s > 0 ? 1 : 0; };
  first.interrupted = [&] { return looks >= 45; };
  first.checkpoint = [&](const std::string& state, std::int64_t) { listener.resume_from = state; };
  ASSERT_EQ(simulate(in_a_plain(), settings, first).status, RunStatus::interrupted);
  listener.frame = [&](const Frame& f) { resumed = f; };
  simulate(in_a_plain(), settings, listener);
  EXPECT_EQ(whole.x, resumed.x);
  EXPECT_EQ(whole.velocity_z, resumed.velocity_z);
  EXPECT_EQ(whole.stress_xz, resumed.stress_xz);
}

TEST(Rest, AnyNumberOfThreadsGivesTheSameBytes) {
  RunSettings settings = coarse();
  settings.stop.max_time_s = 5;
  Frame one, two;
  Listener listener;
  listener.frame = [&](const Frame& f) { one = f; };
  simulate(in_a_plain(), settings, listener);
  listener.frame = [&](const Frame& f) { two = f; };
  simulate(in_a_plain(), settings, listener, 2);
  EXPECT_EQ(one.x, two.x);
  EXPECT_EQ(one.stress_xz, two.stress_xz);
}

}  // namespace
}  // namespace leda::solver::test
