#include "solver/run/observe.hpp"

#include <gtest/gtest.h>

#include <ranges>

#include "solver/run/simulate.hpp"
#include "tests/solver/bank.hpp"
#include "tests/solver/moving_bank.hpp"

namespace leda::solver::test {
namespace {

struct Slid {
  Section section = bank(10, 45, 20e3);
  CrestAndToe bank_points{{40, 10}, {50, 0}};
  Seeded seeded = seed_particles(section, {1, 4, 0});
  Surface before = surface(model(), seeded);

  AnyModel model() const { return model_of<double>(seeded); }
  Movement measured() const { return measure(model(), seeded, section, bank_points, before); }

  // Lowers what was seeded above elevation 8 between two x of the plateau, onto the floor.
  void slide(double from, double to) {
    for (Particle& p : seeded.particles) {
      if (p.x > from && p.x < to && p.z > 11) {
        p.x += 50 - to + (to - from) * (p.z - 11) / 2;
        p.z = 3.5;
      }
    }
  }
};

TEST(Observe, NothingMovedIsNothingMeasured) {
  const Slid s;
  const Movement m = s.measured();
  EXPECT_EQ(m.retrogression_m, 0);
  EXPECT_EQ(m.runout_m, 0);
  EXPECT_EQ(m.front, s.bank_points.toe);
}

TEST(Observe, RetrogressionReachesTheLastColumnThatDropped) {
  Slid s;
  s.slide(25, 40);
  const Movement m = s.measured();
  EXPECT_DOUBLE_EQ(m.retrogression_m, 15);
  EXPECT_DOUBLE_EQ(m.backscarp.x, 25);
  EXPECT_GT(m.runout_m, 1);
}

TEST(Observe, ADropBelowTheThresholdIsNone) {
  Slid s;
  for (Particle& p : s.seeded.particles) p.z -= 0.4;
  EXPECT_EQ(s.measured().retrogression_m, 0);
}

// A face that is exactly vertical: crest and toe have one x, and each side counts as its own.
TEST(Observe, AVerticalFaceIsMeasuredOnTheSideItFallsTo) {
  Slid right;
  right.section.ground = {{0, 10}, {50, 10}, {50, 0}, {100, 0}};
  right.bank_points = {{50, 10}, {50, 0}};
  Slid left;
  left.section.ground = {{0, 0}, {50, 0}, {50, 10}, {100, 10}};
  left.bank_points = {{50, 10}, {50, 0}};
  for (Slid* one : {&right, &left}) {
    one->seeded = seed_particles(one->section, {1, 4, 0});
    one->before = surface(one->model(), one->seeded);
    // The uppermost 5 m of the outer 20 m, turned over onto the floor.
    for (Particle& p : one->seeded.particles) {
      if (std::abs(p.x - 50) > 20 || p.z < 8 || p.z > 13 + 1e-9) continue;
      p.x = 100 - p.x;
      p.z -= 5;
    }
    const Movement m = one->measured();
    EXPECT_DOUBLE_EQ(m.retrogression_m, 20);
    EXPECT_DOUBLE_EQ(m.runout_m, 20);
    EXPECT_FALSE(m.far_side_dropped);
    EXPECT_DOUBLE_EQ(
        retrogression(one->before, surface(one->model(), one->seeded), one->bank_points), 20);
  }
}

TEST(Observe, ALumpFarAheadIsNotTheFront) {
  Slid s;
  s.seeded.particles[0].x = 70;  // from the bank, thrown 20 m past the toe on its own
  s.seeded.particles[0].z = 6;
  EXPECT_EQ(s.measured().runout_m, 0);
}

TEST(Observe, ABankThatFallsToTheLeftIsTheMirrorImage) {
  Slid right;
  right.slide(25, 40);
  Section section = right.section;
  const double length = section.ground.back().x;
  Polyline ground;
  for (const Point& at : std::views::reverse(section.ground)) {
    ground.push_back({length - at.x, at.z});
  }
  section.ground = ground;
  Seeded mirrored = right.seeded;
  for (Particle& p : mirrored.particles) p.x = length - p.x;
  for (float& x : mirrored.start_x) x = static_cast<float>(length) - x;
  Surface before = right.before;
  std::reverse(before.z.begin(), before.z.end());
  const CrestAndToe points{{length - 40, 10}, {length - 50, 0}};
  const Movement a = right.measured();
  const Movement b = measure(model_of<double>(mirrored), mirrored, section, points, before);
  EXPECT_NEAR(a.retrogression_m, b.retrogression_m, 1e-9);
  EXPECT_NEAR(a.runout_m, b.runout_m, 1e-9);
}

// A backscarp drawn in units of the bank: times in sqrt(H / g), retreats in H, read in columns.
class DrawnRetreat {
 public:
  DrawnRetreat(double height_m, double cell_m)
      : height_(height_m),
        cell_(cell_m),
        unit_s_(std::sqrt(height_m / gravity)),
        slides_(height_m, cell_m) {}

  /// @param speed in sqrt(g H), so that 1 is the speed the rule is about
  DrawnRetreat& go(double times, double speed) {
    const double end = time_ + times * unit_s_;
    while (time_ < end) {
      const double dt = slides_.look_interval_s();
      time_ += dt;
      retreat_ += speed * height_ / unit_s_ * dt;
      slides_.observe(time_, cell_ * std::floor(retreat_ / cell_));
    }
    return *this;
  }
  /// All at once, as a block lets go.
  DrawnRetreat& jump(double heights) {
    retreat_ += heights * height_;
    return go(0.5, 0);
  }
  int count() const { return slides_.count(); }

 private:
  double height_, cell_, unit_s_, time_ = 0, retreat_ = 0;
  SlideCount slides_;
};

TEST(SlideCount, CountsTheSameAtEveryHeightOfABank) {
  for (const double height : {2.0, 5.0, 16.7, 30.0, 80.0}) {
    DrawnRetreat bank(height, height / 20);
    bank.go(2, 0.3).jump(0.7).go(3, 0.4).go(0.6, 2.0).go(3, 0.2).jump(0.5).go(4, 0);
    EXPECT_EQ(bank.count(), 3) << height;
  }
}

TEST(SlideCount, CrumblingIsNoSlideHoweverFarItGoes) {
  EXPECT_EQ(DrawnRetreat(5, 0.3).go(50, 0.6).count(), 0);
  EXPECT_EQ(DrawnRetreat(16.7, 1).go(50, 0.6).count(), 0);
}

TEST(SlideCount, ColumnsThatGoOneByOneOnCoarseCellsAreNoSlide) {
  DrawnRetreat bank(4, 1);  // H / 4 is a single cell
  for (int i = 0; i < 5; ++i) bank.jump(0.25).go(1, 0);
  EXPECT_EQ(bank.count(), 0);
  EXPECT_EQ(bank.jump(1).count(), 1);
}

TEST(SlideCount, OneLongBurstIsOneSlide) { EXPECT_EQ(DrawnRetreat(10, 0.5).go(3, 1.5).count(), 1); }

TEST(SlideCount, ABackscarpThatWaversWithinACellDoesNotCount) {
  SlideCount slides(5, 0.3);
  for (int i = 0; i < 200; ++i) slides.observe(0.06 * i, i % 2 == 0 ? 3.0 : 3.3);
  EXPECT_EQ(slides.count(), 0);
}

Section five_metres(double peak_strength) {
  Section s = bank(5, 45, peak_strength);
  s.ground = {{0, 5}, {20, 5}, {25, 0}, {40, 0}};
  s.base_m = -1;
  return s;
}

RunSettings five_metre_settings(double seconds) {
  RunSettings settings;
  settings.resolution.cell_m = 0.5;
  settings.stop.max_time_s = seconds;
  return settings;
}

// Row 25 / 3.0 / 90 of Table 0-1 of the thesis: on pictures one wedge lets go, and its scarp then
// crumbles back column by column (until the edge of the model, after 7 s).
TEST(SlideCount, ABankOfFiveMetresThatCrumblesSlidOnce) {
  Section s = five_metres(25e3);
  s.materials["clay"].softening =
      Softening{ExponentialSoftening{3e3, 90}, 0.014, Regularization::none};
  RunSettings settings = five_metre_settings(6);
  settings.trigger = UndrainedTrigger{3.0};
  const SectionResult r = simulate(s, settings);
  EXPECT_GT(r.crest_to_crest_retrogression_m, 3);
  EXPECT_EQ(r.slides, 1);
}

// On pictures a first block is gone at 1 s, the crest crumbles, and a second block with a horst of
// whole clay behind the first lets go at 2.8 s.
TEST(SlideCount, ABankOfFiveMetresThatGoesInBlocksSlidMoreThanOnce) {
  const SectionResult r = simulate(five_metres(13e3), five_metre_settings(4));
  EXPECT_GE(r.slides, 2);
  EXPECT_LE(r.slides, 3);
}

TEST(Observe, AFrameIsInTheOrderOfSeeding) {
  const Slid s;
  const Frame f = frame(s.model(), s.seeded, 1.5);
  ASSERT_EQ(f.x.size(), s.seeded.particles.size());
  EXPECT_EQ(f.time_s, 1.5);
  EXPECT_NEAR(f.x[0], 0.25, 1e-6);
  EXPECT_NEAR(f.z[0], -2.75, 1e-6);
  EXPECT_NEAR(f.z[1], -2.25, 1e-6);
  EXPECT_FLOAT_EQ(f.strength[0], 20e3F);
}

}  // namespace
}  // namespace leda::solver::test
