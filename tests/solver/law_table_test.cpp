#include "solver/materials/law_table.hpp"

#include <gtest/gtest.h>

#include "tests/solver/bank.hpp"

namespace leda::solver::test {
namespace {

TEST(LawTable, ParticlesOfOneStrengthShareARow) {
  const Section s = bank(10, 25, 20e3);
  LawTableBuilder laws(s, 1);
  EXPECT_EQ(laws.row(0, 1, 0), laws.row(0, 7, 3));
  EXPECT_EQ(laws.table().rows(), 1U);
  EXPECT_DOUBLE_EQ(laws.table().peak[0], 20e3);
}

TEST(LawTable, StrengthByDepthIsKeptWithinATenthOfAPercent) {
  Section s = bank(10, 25, 20e3);
  Strength& strength = s.materials.begin()->second.peak_strength;
  strength.by = Strength::By::depth;
  strength.table = {{0, 20e3}, {10, 40e3}};
  LawTableBuilder laws(s, 1);
  for (int i = 0; i < 33; ++i) {
    const double depth = 0.37 * i;
    const auto row = static_cast<std::size_t>(laws.row(0, depth, 0));
    EXPECT_NEAR(laws.table().peak[row], strength.at(depth, 0), 0.0005 * 40e3 + 1e-9);
  }
}

TEST(LawTable, WithoutSofteningTheStrengthStaysAtItsPeak) {
  const Section s = bank(10, 25, 20e3);
  LawTableBuilder laws(s, 1);
  laws.row(0, 1, 0);
  const LawTable plain = without_softening(laws.table(), false);
  EXPECT_DOUBLE_EQ(strength(plain.curve(0), 5.0), 20e3);
  EXPECT_LT(strength(laws.table().curve(0), 5.0), 2e3);
}

}  // namespace
}  // namespace leda::solver::test
