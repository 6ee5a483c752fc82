// A run that goes wrong ends early, says why, and leaves the last sound state.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/extremes/banks.hpp"
#include "solver/extremes/finite.hpp"
#include "solver/run/simulate.hpp"

namespace leda::solver::test {
namespace {

const Section& section() {
  static const Section bank = bank_of_clay({.angle_deg = 30}, sensitive_clay(25e3, 500));
  return bank;
}

RunSettings settings_with(double time_step_factor) {
  RunSettings settings = settings_of(1, 10);
  settings.time_step_factor = time_step_factor;
  settings.output.frame_interval_s = 0.5;
  return settings;
}

struct Recorded {
  SectionResult result;
  std::vector<Frame> frames;
};

Recorded record(const RunSettings& settings, const std::string& state = "") {
  Recorded r;
  Listener listener;
  listener.frame = [&](const Frame& f) { r.frames.push_back(f); };
  listener.resume_from = state;
  r.result = simulate(section(), settings, listener);
  return r;
}

// A sliding bank with a sound time step, as it is after three seconds or so.
std::string state_of_a_slide() {
  std::string state;
  double time = 0;
  Listener listener;
  listener.progress = [&](const Progress& p) { time = p.time_s; };
  listener.interrupted = [&] { return time > 3; };
  listener.checkpoint = [&](const std::string& s, std::int64_t) { state = s; };
  listener.checkpoint_interval_s = 1e9;
  simulate(section(), settings_with(0.9), listener);  // long steps too: states of short ones differ
  return state;
}

void expect_sound(const Recorded& r) {
  EXPECT_EQ(r.result.status, RunStatus::unstable);
  EXPECT_NE(r.result.reason.find("the sound state at"), std::string::npos) << r.result.reason;
  EXPECT_TRUE(is_finite(r.result));
  ASSERT_FALSE(r.frames.empty());
  double time = 0;
  for (const Frame& f : r.frames) {
    EXPECT_TRUE(is_finite(f)) << f.time_s;
    EXPECT_GE(f.time_s, time);
    time = f.time_s;
    for (std::size_t i = 0; i < f.x.size(); ++i) {
      ASSERT_LT(std::hypot(f.velocity_x[i], f.velocity_z[i]), 30);
    }
  }
  EXPECT_EQ(r.result.simulated_s, r.frames.back().time_s);
}

TEST(UnstableRun, WhileItSlidesEndsWithTheLastSoundState) {
  const std::string state = state_of_a_slide();
  ASSERT_FALSE(state.empty());
  const Recorded r = record(settings_with(2.5), state);
  expect_sound(r);
  EXPECT_GE(r.result.simulated_s, 3);
  EXPECT_LT(r.result.simulated_s, 9);
  EXPECT_GT(r.result.crest_to_crest_retrogression_m, 1);
  const Frame& last = r.frames.back();
  EXPECT_GT(*std::ranges::max_element(last.plastic_strain), 0.5F);
}

TEST(UnstableRun, BeforeItMovesEndsWithTheSeeds) {
  const Recorded r = record(settings_with(2.5));
  expect_sound(r);
  EXPECT_EQ(r.result.crest_to_crest_retrogression_m, 0);
  EXPECT_EQ(r.result.simulated_s, 0);
}

TEST(UnstableRun, IsTheSameEveryTime) {
  const std::string state = state_of_a_slide();
  const Recorded a = record(settings_with(2.5), state), b = record(settings_with(2.5), state);
  EXPECT_EQ(a.result.reason, b.result.reason);
  EXPECT_EQ(a.frames.back().x, b.frames.back().x);
}

}  // namespace
}  // namespace leda::solver::test
