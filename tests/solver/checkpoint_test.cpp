#include "solver/run/checkpoint.hpp"

#include <gtest/gtest.h>

#include "solver/run/initial_stress.hpp"
#include "tests/solver/bank.hpp"

namespace leda::solver::test {
namespace {

struct Recorded {
  SectionResult result;
  std::vector<Frame> frames;
  std::string state;        ///< of the checkpoint asked for
  std::int64_t before = 0;  ///< frames handed over before it
};

RunSettings with_frames() {
  RunSettings settings = coarse();
  settings.stop.max_time_s = 6;
  settings.output.frame_interval_s = 1;
  return settings;
}

// A run, interrupted after some looks (never: 0), or resumed from a state.
Recorded record(const RunSettings& settings, int looks, const std::string& from = "",
                double height = 10, double strength = 25e3) {
  Recorded r;
  int count = 0;
  Listener listener;
  listener.frame = [&](const Frame& f) { r.frames.push_back(f); };
  listener.progress = [&](const Progress& p) { count += p.time_s > 0 ? 1 : 0; };
  listener.interrupted = [&] { return looks > 0 && count >= looks; };
  listener.checkpoint = [&](const std::string& state, std::int64_t frames) {
    r.state = state;
    r.before = frames;
  };
  listener.checkpoint_interval_s = 1e9;
  listener.resume_from = from;
  r.result = simulate(bank(height, 30, strength), settings, listener);
  return r;
}

void expect_same(const Recorded& whole, const Recorded& first, const Recorded& second) {
  EXPECT_EQ(second.result.status, whole.result.status);
  EXPECT_EQ(second.result.steps, whole.result.steps);
  EXPECT_EQ(second.result.slides, whole.result.slides);
  EXPECT_EQ(second.result.trigger_used, whole.result.trigger_used);
  EXPECT_EQ(second.result.crest_to_crest_retrogression_m,
            whole.result.crest_to_crest_retrogression_m);
  EXPECT_EQ(second.result.balances.energy, whole.result.balances.energy);
  const auto before = static_cast<std::size_t>(first.before);
  ASSERT_EQ(before + second.frames.size(), whole.frames.size());
  for (std::size_t i = 0; i < second.frames.size(); ++i) {
    EXPECT_EQ(second.frames[i].x, whole.frames[before + i].x) << i;
    EXPECT_EQ(second.frames[i].stress_xz, whole.frames[before + i].stress_xz) << i;
    EXPECT_EQ(second.frames[i].plastic_strain, whole.frames[before + i].plastic_strain) << i;
  }
}

TEST(Checkpoint, AResumedRunGivesTheSameBytes) {
  const Recorded whole = record(with_frames(), 0);
  for (const int looks : {1, 17, 40}) {
    const Recorded first = record(with_frames(), looks);
    ASSERT_EQ(first.result.status, RunStatus::interrupted);
    ASSERT_FALSE(first.state.empty());
    expect_same(whole, first, record(with_frames(), 0, first.state));
  }
}

// With long steps thin ground depends on the masses of nodes, also beside ground at rest.
TEST(Checkpoint, AResumedRunOfLongStepsGivesTheSameBytes) {
  RunSettings settings = with_frames();
  settings.time_step_factor = 0.95;
  const Recorded whole = record(settings, 0);
  const Recorded first = record(settings, 17);
  ASSERT_EQ(first.result.status, RunStatus::interrupted);
  expect_same(whole, first, record(settings, 0, first.state));
}

TEST(Checkpoint, AResumedToeCutIsNotCutTwice) {
  RunSettings settings = with_frames();
  settings.trigger = UndrainedTrigger{2.0};
  const Recorded whole = record(settings, 0, "", 6, 60e3);
  ASSERT_EQ(whole.result.trigger_used, "toe-cut");
  for (const int looks : {5, 15}) {
    const Recorded first = record(settings, looks, "", 6, 60e3);
    ASSERT_EQ(first.result.status, RunStatus::interrupted);
    expect_same(whole, first, record(settings, 0, first.state, 6, 60e3));
  }
}

TEST(Checkpoint, BytesThatAreNoStateOfTheRunAreRefused) {
  const Recorded first = record(with_frames(), 3);
  const Section section = bank(10, 30, 25e3);
  const RunSettings settings = with_frames();
  RunState run;
  run.settings = &settings;
  run.seeded = seed_particles(section, settings.resolution);
  begin_quiet(run);
  EXPECT_FALSE(load_state("", run));
  EXPECT_FALSE(load_state("nonsense of some length, longer than the header", run));
  EXPECT_FALSE(load_state(first.state.substr(0, first.state.size() / 2), run));
  EXPECT_FALSE(load_state(first.state + "x", run));
  // A program that holds other numbers, or calls them otherwise, is told by what the bytes hold.
  for (const std::string name : {"plastic_strain", "packs.pack", "audit.kinetic_peak"}) {
    std::string renamed = first.state;
    const std::size_t at = renamed.find(name);
    ASSERT_NE(at, std::string::npos) << name;
    renamed[at] = 'q';
    EXPECT_FALSE(load_state(renamed, run)) << name;
  }
  const std::size_t size_of_pack =
      first.state.find("packs.pack") + std::string("packs.pack").size();
  std::string wider = first.state;
  ++wider[size_of_pack];
  EXPECT_FALSE(load_state(wider, run));
  RunState other;
  other.settings = &settings;
  other.seeded = seed_particles(bank(5, 30, 25e3), with_frames().resolution);
  begin_quiet(other);
  EXPECT_FALSE(load_state(first.state, other));
  EXPECT_TRUE(load_state(first.state, run));
  EXPECT_TRUE(run.resumed);
}

}  // namespace
}  // namespace leda::solver::test
