#include "solver/observe.hpp"

#include <gtest/gtest.h>

#include "tests/solver/bank.hpp"

namespace leda::solver::test {
namespace {

struct Slid {
  Section section = bank(10, 45, 20e3);
  CrestAndToe bank_points{{40, 10}, {50, 0}};
  Seeded seeded = seed_particles(section, {1, 4, 0});
  Surface before = surface(seeded);

  // Lowers what was seeded above elevation 8 between two x of the plateau, onto the floor.
  void slide(double from, double to) {
    Particles& p = seeded.particles;
    for (std::size_t i = 0; i < p.count; ++i) {
      if (p.x[i] > from && p.x[i] < to && p.z[i] > 11) {
        p.x[i] += 50 - to + (to - from) * (p.z[i] - 11) / 2;
        p.z[i] = 3.5;
      }
    }
  }
};

TEST(Observe, NothingMovedIsNothingMeasured) {
  const Slid s;
  const Movement m = measure(s.seeded, s.section, s.bank_points, s.before);
  EXPECT_EQ(m.retrogression_m, 0);
  EXPECT_EQ(m.runout_m, 0);
  EXPECT_EQ(m.front, s.bank_points.toe);
}

TEST(Observe, RetrogressionReachesTheLastColumnThatDropped) {
  Slid s;
  s.slide(25, 40);
  const Movement m = measure(s.seeded, s.section, s.bank_points, s.before);
  EXPECT_DOUBLE_EQ(m.retrogression_m, 15);
  EXPECT_DOUBLE_EQ(m.backscarp.x, 25);
  EXPECT_GT(m.runout_m, 1);
}

TEST(Observe, ADropBelowTheThresholdIsNone) {
  Slid s;
  Particles& p = s.seeded.particles;
  for (std::size_t i = 0; i < p.count; ++i) p.z[i] -= 0.4;
  EXPECT_EQ(measure(s.seeded, s.section, s.bank_points, s.before).retrogression_m, 0);
}

TEST(Observe, ALumpFarAheadIsNotTheFront) {
  Slid s;
  Particles& p = s.seeded.particles;
  p.x[0] = 70;  // from the bank, thrown 20 m past the toe on its own
  p.z[0] = 6;
  EXPECT_EQ(measure(s.seeded, s.section, s.bank_points, s.before).runout_m, 0);
}

TEST(Observe, ABankThatFallsToTheLeftIsTheMirrorImage) {
  Slid right;
  right.slide(25, 40);
  Section section = right.section;
  const double length = section.ground.back().x;
  Polyline ground;
  for (auto at = section.ground.rbegin(); at != section.ground.rend(); ++at) {
    ground.push_back({length - at->x, at->z});
  }
  section.ground = ground;
  Seeded mirrored = right.seeded;
  for (std::size_t i = 0; i < mirrored.particles.padded(); ++i) {
    mirrored.particles.x[i] = length - mirrored.particles.x[i];
    mirrored.particles.start_x[i] = length - mirrored.particles.start_x[i];
  }
  Surface before = right.before;
  std::reverse(before.z.begin(), before.z.end());
  const CrestAndToe points{{length - 40, 10}, {length - 50, 0}};
  const Movement a = measure(right.seeded, right.section, right.bank_points, right.before);
  const Movement b = measure(mirrored, section, points, before);
  EXPECT_NEAR(a.retrogression_m, b.retrogression_m, 1e-9);
  EXPECT_NEAR(a.runout_m, b.runout_m, 1e-9);
}

TEST(SlideCount, CountsBurstsNotCrumbling) {
  SlideCount slides;
  double r = 0, t = 0;
  const auto go = [&](double seconds, double rate) {
    for (double s = 0; s < seconds; s += 0.1) {
      t += 0.1;
      r += rate * 0.1;
      slides.observe(t, r);
    }
  };
  go(2, 3);  // crumbling at 3 m/s
  EXPECT_EQ(slides.count(), 0);
  go(1, 30);
  go(2, 2);
  go(1, 25);
  EXPECT_EQ(slides.count(), 2);
  go(3, 0);
  EXPECT_EQ(slides.count(), 2);
}

TEST(Observe, AFrameIsInTheOrderOfSeeding) {
  const Slid s;
  const Frame f = frame(s.seeded, s.seeded.laws, 1.5);
  ASSERT_EQ(f.x.size(), s.seeded.particles.count);
  EXPECT_EQ(f.time_s, 1.5);
  EXPECT_NEAR(f.x[0], 0.25, 1e-6);
  EXPECT_NEAR(f.z[0], -2.75, 1e-6);
  EXPECT_NEAR(f.z[1], -2.25, 1e-6);
  EXPECT_FLOAT_EQ(f.strength[0], 20e3F);
}

}  // namespace
}  // namespace leda::solver::test
