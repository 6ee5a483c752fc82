#include "solver/materials/law_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

Section varying_bank() {
  Section s = bank(10, 25, 20e3);
  s.materials["clay"].field = RandomField{0.2, 20, 2};
  return s;
}

TEST(LawTable, AFieldsStrengthIsKeptWithinAnEighthOfItsStandardDeviation) {
  const Section s = varying_bank();
  LawTableBuilder laws(s, 1);
  std::int32_t before = 0;
  for (double factor = 0.5; factor < 2; factor *= 1.01) {
    const std::int32_t row = laws.row(0, 1, 0, 0, factor);
    EXPECT_GE(row, before) << "rows rise with the strength";
    before = row;
    const double peak = laws.table().peak[static_cast<std::size_t>(row)];
    EXPECT_LE(std::abs(std::log(peak / (factor * 20e3))), std::sqrt(std::log1p(0.04)) / 8 + 1e-9);
  }
  EXPECT_LT(laws.table().rows(), 50U);
}

TEST(LawTable, AFieldBeyondItsReachTakesTheOutermostRow) {
  const Section s = varying_bank();
  LawTableBuilder laws(s, 1);
  EXPECT_EQ(laws.row(0, 1, 0, 0, 1e-3), 0);
  EXPECT_EQ(laws.row(0, 1, 0, 0, 1e3), static_cast<std::int32_t>(laws.table().rows()) - 1);
}

TEST(LawTable, ResidualStrengthFollowsAFieldAndRemoldedStrengthStays) {
  const Section s = varying_bank();
  LawTableBuilder laws(s, 0.014);
  for (const double factor : {0.5, 1.5}) {
    const auto row = static_cast<std::size_t>(laws.row(0, 1, 0, 0, factor));
    const SofteningCurve curve = laws.table().curve(row);
    EXPECT_DOUBLE_EQ(curve.line_start, 0.095 * curve.peak);
    EXPECT_DOUBLE_EQ(curve.last, 400);
  }
}

// Far down the remolded strength that is given, and the tensile one, lie above the peak.
TEST(LawTable, NoStrengthIsAboveThePeakThatAFieldLeaves) {
  Section s = varying_bank();
  Material& clay = s.materials["clay"];
  std::get<UrmiSoftening>(clay.softening->law).remolded_strength_Pa = 1.8e3;
  clay.tensile_strength_Pa = 30e3;
  clay.rate = SemiLogarithmicRate{0.1, 1.4e-5};
  clay.field->cov = 1;
  LawTableBuilder laws(s, 1);
  const auto row = static_cast<std::size_t>(laws.row(0, 1, 0, 0, 0.03));
  const LawTable& t = laws.table();
  EXPECT_LT(t.peak[row], 0.7e3);
  EXPECT_EQ(t.last[row], t.peak[row]);
  EXPECT_EQ(t.viscous.remolded[row], t.peak[row]);
  EXPECT_EQ(t.tension[row], 2 * t.peak[row]);
  EXPECT_EQ(t.tension[static_cast<std::size_t>(laws.row(0, 1, 0, 0, 1))], 30e3);
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
