#include "tests/verification/manufactured.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/verification/record.hpp"

namespace leda::solver::test {
namespace {

template <class Real>
class Manufactured : public ::testing::Test {
 protected:
  struct Errors {
    double coarse, middle, fine;
    double first_order() const { return std::log2(coarse / middle); }
    double second_order() const { return std::log2(middle / fine); }
  };

  static Errors errors(double across, double time_step_factor) {
    const auto error = [&](int cells) {
      return displacement_error<Real>(
          {.cells = cells, .across = across, .per_side = 4, .time_step_factor = time_step_factor});
    };
    const Errors e{error(8), error(16), error(32)};
    leda::test::record("errors ", e.coarse, ", ", e.middle, ", ", e.fine,
                       " with 8, 16, 32 cells: order ", e.first_order(), ", ", e.second_order());
    return e;
  }

  // The order is 2 until the quadrature of one particle for each piece of a deforming cell takes
  // over, and 1 from there on: with 4 x 4 particles the errors are 0.0088, 0.0020, 0.0009, 0.0004
  // at 8, 16, 32 and 64 cells. The file asks for about 2 before saturation and 1 - 0.2 at the
  // least.
  static void expect_orders(const Errors& e) {
    EXPECT_GT(e.first_order(), 1.8) << e.coarse << " " << e.middle;
    EXPECT_GT(e.second_order(), 0.8) << e.middle << " " << e.fine;
    EXPECT_LT(e.fine, 0.002);
  }
};
TYPED_TEST_SUITE(Manufactured, BothPrecisions, PrecisionNames);

// validation case mms_axis_aligned_displacement (Wallstedt and Guilkey 2008; Sadeghirad et al.
// 2011), E = 1e7 Pa, rho0 = 1000 kg/m3, A = 0.05 m. Two changes the solver asks for, with the body
// force derived anew: its law is elastic in the rate form, which for motions along the axes is
// Cauchy stress = E ln F (nu = 0); and a base that sticks leaves no unit square with four smooth
// walls. So the sides are the walls of u and the block hangs free above and below, where the
// manufactured v has no strain. Without it (`across` 0) the problem is that of a bar.
TYPED_TEST(Manufactured, ABarBetweenWallsConverges) { this->expect_orders(this->errors(0, 0.05)); }
TYPED_TEST(Manufactured, ABlockWithFreeEdgesConverges) {
  this->expect_orders(this->errors(1, 0.05));
}

// Long steps lower the moduli of ground at a free edge: a strip of it, narrower than a cell, has
// less stiffness than the body force counts on. So the order is 1, and the error, much the same for
// steps of any length once the ground is softer (0.0211 to 0.0358 at 8 cells, 0.0070 to 0.0076 at
// 32), is 0.25 cells over the bar's width for a block that is strained across too and 0.37 for a
// bar strained along its free edges alone.
TYPED_TEST(Manufactured, LongStepsConvergeWithFirstOrder) {
  const auto e = this->errors(1, 0.95);
  EXPECT_GT(e.first_order(), 0.8);
  EXPECT_GT(e.second_order(), 0.8);
  EXPECT_LT(e.fine, 0.30 / 32);
}
TYPED_TEST(Manufactured, LongStepsSoftenTheFreeEdgesOfABar) {
  const auto e = this->errors(0, 0.95);
  EXPECT_GT(e.first_order(), 0.8);
  EXPECT_GT(e.second_order(), 0.8);
  EXPECT_LT(e.fine, 0.45 / 32);
}

}  // namespace
}  // namespace leda::solver::test
