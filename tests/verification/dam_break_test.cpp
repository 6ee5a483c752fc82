#include "tests/verification/dam_break.hpp"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "tests/verification/record.hpp"

namespace leda::solver::test {
namespace {

template <class Real>
class DamBreak : public ::testing::Test {};
TYPED_TEST_SUITE(DamBreak, BothPrecisions, PrecisionNames);

using Path = std::vector<std::array<double, 2>>;  // time, value

double at(const Path& path, double time) {
  const auto next = std::lower_bound(path.begin(), path.end(), time,
                                     [](const auto& p, double v) { return p[0] < v; });
  return next == path.end() ? path.back()[1] : (*next)[1];
}

// validation case martin_moyce_dambreak (Martin and Moyce 1952, Table 2): a = 0.05715 m, column 2a
// high; Z = front / a over T = t sqrt(2 g / a), 12 %, with the gate's offset of T between 0 and
// 0.3 left free. Half a per cent of the fluid may be ahead as drops.
TYPED_TEST(DamBreak, FrontOfMartinAndMoyce) {
  constexpr std::array time{0.41, 0.84, 1.19, 1.43, 1.63, 1.83, 1.98, 2.20,
                            2.32, 2.51, 2.65, 2.83, 2.98, 3.11, 3.33};
  constexpr std::array reach{1.11, 1.22, 1.44, 1.67, 1.89, 2.11, 2.33, 2.56,
                             2.78, 3.00, 3.22, 3.44, 3.67, 3.89, 4.11};
  const double a = 0.05715, unit = std::sqrt(a / (2 * Fluid<TypeParam>::g));
  Fluid<TypeParam> fluid({.width = a, .height = 2 * a, .room = 5 * a, .cell = a / 16});
  Path path;
  double t = 0;
  while (t < 3.4 * unit) {
    path.push_back({t / unit, fluid.front(0.005 * 2 * a * a) / a});
    t += fluid.advance();
  }
  double best = 1;
  for (int tried = 0; tried <= 15; ++tried) {
    const double offset = 0.02 * tried;
    double worst = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
      worst = std::max(worst, std::abs(at(path, time[i] - offset) / reach[i] - 1));
    }
    best = std::min(best, worst);
  }
  leda::test::record("largest ", 100 * best, " %");
  EXPECT_LT(best, 0.12);
}

// validation case martin_moyce_dambreak, Table 6: what is left of the column's height at the wall,
// H = h / (2 a) over Y = t sqrt(g / a), 12 %; the same gate, so the same offset, 0 to 0.3 of T. The
// first 12 points, down to a third of the height: what is left then runs off too slowly. Not its
// strength does that (a hundredth of it changes nothing), nor tension (without it, as here, the
// first 12 points are off by 4.7 % in place of 7.7, the last ones still by far), nor locking
// (averaged dilation: the same); what is left is a base that sticks.
TYPED_TEST(DamBreak, HeightOfMartinAndMoyce) {
  constexpr std::array time{0.56, 0.77, 0.93, 1.08, 1.28, 1.46, 1.66, 1.84, 2.00,
                            2.21, 2.45, 2.70, 3.06, 3.44, 4.20, 5.25, 7.40};
  constexpr std::array left{0.94, 0.89, 0.83, 0.78, 0.72, 0.67, 0.61, 0.56, 0.50,
                            0.44, 0.39, 0.33, 0.28, 0.22, 0.17, 0.11, 0.06};
  constexpr std::size_t first = 12;
  const double a = 0.05715, unit = std::sqrt(a / Fluid<TypeParam>::g), cell = a / 32;
  Fluid<TypeParam> fluid({.width = a, .height = 2 * a, .room = 24 * a, .cell = cell});
  Path path;
  double t = 0;
  while (t < 7.5 * unit) {
    path.push_back({t / unit, fluid.depth(cell) / (2 * a)});
    t += fluid.advance();
  }
  double best = 1;
  for (int tried = 0; tried <= 10; ++tried) {
    const double offset = 0.02 * tried;
    double worst = 0;
    for (std::size_t i = 0; i < first; ++i) {
      worst = std::max(worst, std::abs(at(path, time[i] - offset) / left[i] - 1));
    }
    best = std::min(best, worst);
  }
  leda::test::record("largest ", 100 * best, " % down to H = ", left[first - 1], "; later H ",
                     at(path, time[13]), ", ", at(path, time[16]), " where ", left[13], ", ",
                     left[16], " was seen");
  EXPECT_LT(best, 0.12);
}

// validation case ritter_dry_dambreak (Ritter 1892): h = (2 c - x / t)^2 / (9 g), c = sqrt(g h0),
// so an area V lies ahead of x = t (2 c - (27 g V / t)^(1/3)); a particle method is 10 to 25 %
// slower early, here too because the base sticks. The depth at the dam is 4/9 h0; a layer of the
// lowest cell stays behind, so it is 19 % too large with cells of h0 / 20 and 10 % with h0 / 40.
TYPED_TEST(DamBreak, FrontAndDepthOfRitter) {
  const double h0 = 1, dam = 6, ahead = 0.02;
  Fluid<TypeParam> fluid({.width = dam, .height = h0, .room = 8, .cell = 0.025});
  double t = 0;
  while (t < 1.3) t += fluid.advance();
  const double way = t * (2 * std::sqrt(Fluid<TypeParam>::g * h0) -
                          std::cbrt(27 * Fluid<TypeParam>::g * ahead / t));
  const double ratio = (fluid.front(ahead) - dam) / way;
  const double depth = fluid.depth(dam) / h0;
  leda::test::record("way of the front ", ratio, " of Ritter's, depth at the dam ", depth, " h0");
  EXPECT_GT(ratio, 0.75);
  EXPECT_LT(ratio, 1.0);
  EXPECT_NEAR(depth, 4.0 / 9, 0.15 * 4 / 9);
}

}  // namespace
}  // namespace leda::solver::test
