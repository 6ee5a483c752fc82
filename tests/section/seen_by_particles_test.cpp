#include "solver/section/seen_by_particles.hpp"

#include <gtest/gtest.h>

#include "solver/section/validate.hpp"
#include "solver/section/warnings.hpp"
#include "tests/section/bank.hpp"

namespace leda {
namespace {

// A seam between two elevations in one clay; particles stand 0.5 m apart, at 0.25, 0.75, ...
Section with_seam(double top, double bottom) {
  Section s = test::bank();
  s.layers = {test::layer("clay"), test::layer("seam"), test::layer("clay")};
  s.layers[0].bottom_m = top;
  s.layers[1].bottom_m = bottom;
  s.materials = {{"clay", test::softening_clay()}, {"seam", test::softening_clay()}};
  return s;
}

RunSettings cells_of(double cell_m) {
  RunSettings settings;
  settings.resolution.cell_m = cell_m;
  return settings;
}

std::string text(const std::vector<std::string>& lines) {
  std::string all;
  for (const auto& line : lines) all += line + "\n";
  return all;
}

TEST(SeenByParticles, LayersAreCountedAsTheRowsInThem) {
  const Section s = with_seam(3.5, 2.5);
  const auto seen = seen_layers(s, cells_of(1).resolution);
  ASSERT_EQ(seen.size(), 3U);
  EXPECT_NEAR(seen[1].seen.area_m2, 100, 1e-9);
  EXPECT_NEAR(seen[1].seen.seen_m2, 100, 1e-9);
  EXPECT_NEAR(seen[1].seen.length_m, 100, 1e-9);
  EXPECT_EQ(seen[1].seen.missed_m, 0);
  double area = 0;
  for (const SeenLayer& layer : seen) area += layer.seen.area_m2;
  EXPECT_NEAR(area, 40 * 20 + 30 * 12.5 + 30 * 5, 1);
}

TEST(SeenByParticles, EachColumnHasItsLayers) {
  Section s = with_seam(3.5, 2.5);
  s.columns = {{0, 30, s.layers}, {30, 100, {test::layer("clay")}}};
  s.layers.clear();
  const auto seen = seen_layers(s, cells_of(1).resolution);
  ASSERT_EQ(seen.size(), 4U);
  EXPECT_NEAR(seen[1].seen.area_m2, 30, 1e-9);
  EXPECT_EQ(seen[3].list, 1U);
  EXPECT_NEAR(seen[3].seen.length_m, 70, 1e-9);
}

TEST(SeenByParticles, AColumnNarrowerThanACellIsRefused) {
  Section s = test::bank();
  s.columns = {{0, 30, s.layers}, {30, 30.4, s.layers}, {30.4, 100, s.layers}};
  s.layers.clear();
  const auto faults = validate(s, cells_of(0.5));
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].pointer, "/columns/1");
  EXPECT_TRUE(validate(s, cells_of(0.4)).empty());
}

TEST(SeenByParticles, ASeamBetweenTwoRowsIsRefusedWithTheCellThatSeesIt) {
  const auto faults = validate(with_seam(3.24, 2.76), cells_of(1));
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].pointer, "/layers/1");
  EXPECT_NE(faults[0].message.find("(seam) holds no particle: it is 0.48 m thick"),
            std::string::npos)
      << faults[0].message;
  EXPECT_NE(faults[0].message.find("at most 0.96 m"), std::string::npos) << faults[0].message;
  EXPECT_TRUE(validate(with_seam(3.24, 2.76), cells_of(0.96)).empty());
}

TEST(SeenByParticles, ASeamAroundARowIsTakenAsItIs) {
  const Section s = with_seam(3.0, 2.52);
  EXPECT_TRUE(validate(s, cells_of(1)).empty());
  EXPECT_EQ(text(warnings_of(s, cells_of(1))).find("seam"), std::string::npos);
}

TEST(SeenByParticles, AThicknessThatIsRoundedIsTold) {
  const Section s = with_seam(2.9, 2.6);
  EXPECT_TRUE(validate(s, cells_of(1)).empty());
  const std::string told = text(warnings_of(s, cells_of(1)));
  EXPECT_NE(told.find("layer 2 (seam) is 0.3 m thick and acts as 0.5 m"), std::string::npos)
      << told;
  EXPECT_NE(told.find("at most 0.12 m"), std::string::npos) << told;
}

TEST(SeenByParticles, ASeamThatRunsAcrossTheRowsIsToldWhereItIsLost) {
  Section s = with_seam(0, 0);
  s.layers[0].bottom_m.reset();
  s.layers[1].bottom_m.reset();
  s.layers[0].bottom = {{0, 1.3}, {100, 4.3}};
  s.layers[1].bottom = {{0, 1.0}, {100, 4.0}};
  const std::string told = text(warnings_of(s, cells_of(1)));
  EXPECT_NE(told.find("layer 2 (seam) is thinner than the particles' spacing (0.5 m) along 40 %"),
            std::string::npos)
      << told;
}

TEST(SeenByParticles, ASliceOfOneClayIsNoBodyOfItsOwn) {
  Section s = with_seam(3.24, 2.76);
  s.layers[1].material = "clay";
  EXPECT_TRUE(validate(s, cells_of(1)).empty());
}

// One clay with the rows, in kPa, of a table of its strength.
Section with_table(Strength::By by, std::vector<std::array<double, 2>> rows) {
  Section s = test::bank();
  s.layers = {test::layer("clay")};
  s.materials = {{"clay", test::elastic_plastic()}};
  Strength& strength = s.materials.at("clay").peak_strength;
  strength.by = by;
  strength.table = std::move(rows);
  for (auto& [at, value] : strength.table) value *= 1000;
  return s;
}

std::string told_of(const Section& s, double cell_m) {
  EXPECT_TRUE(validate(s, cells_of(cell_m)).empty());
  return text(warnings_of(s, cells_of(cell_m)));
}

TEST(StrengthExtremes, AreThoseThatDifferOnBothSides) {
  Strength strength;
  strength.by = Strength::By::elevation;
  strength.table = {{0, 40}, {1, 40}, {1.5, 8}, {2, 8.5}, {2.5, 8}, {3, 40},
                    {4, 41}, {5, 40}, {6, 80},  {7, 50},  {8, 60},  {9, 70}};
  const auto found = extremes_of(strength);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].strength_Pa, 8);
  EXPECT_TRUE(found[0].is_dip);
  EXPECT_NEAR(found[0].from, 1 + 0.5 * (40 - 8.8) / 32, 1e-12);
  EXPECT_NEAR(found[0].to, 2.5 + 0.5 * 0.8 / 32, 1e-12);
  EXPECT_EQ(found[0].core_from, 1.5);
  EXPECT_EQ(found[0].core_to, 2.5);
  EXPECT_EQ(found[1].strength_Pa, 80);
  EXPECT_FALSE(found[1].is_dip);
  EXPECT_EQ(found[2].strength_Pa, 50);
}

TEST(SeenByParticles, ASeamOfAStrengthTableBetweenTwoRowsIsTold) {
  const Section s =
      with_table(Strength::By::elevation, {{2.76, 45}, {2.77, 8}, {3.23, 8}, {3.24, 45}});
  const std::string told = told_of(s, 1);
  EXPECT_NE(
      told.find("material clay: peak_strength_kPa falls to 8 kPa at elevations of 2.77 to 3.23 m, "
                "between two rows of particles (0.5 m apart) along 100 % of its length, where "
                "none has that strength; a cell of at most 0.92 m sees it\n"),
      std::string::npos)
      << told;
  EXPECT_EQ(told_of(s, 0.92), "");
}

TEST(SeenByParticles, ASeamOfAStrengthTableAroundARowIsTakenAsItIs) {
  EXPECT_EQ(
      told_of(with_table(Strength::By::elevation, {{2.51, 45}, {2.52, 8}, {3.0, 8}, {3.01, 45}}),
              1),
      "");
}

TEST(SeenByParticles, ASeamByDepthIsToldWhereTheGroundIsLevel) {
  const std::string told = told_of(
      with_table(Strength::By::depth, {{10, 45}, {10.01, 8}, {10.19, 8}, {10.2, 45}, {11, 45}}), 1);
  // Under the plateau of 40 m rows stand at depths of 0.25, 0.75, ...; under the slope at any.
  EXPECT_NE(told.find("falls to 8 kPa at depths of 10.01 to 10.19 m, between"), std::string::npos)
      << told;
  EXPECT_EQ(told.find("along 100 %"), std::string::npos) << told;
}

TEST(SeenByParticles, OfManySeamsTheWeakestIsTold) {
  const std::string told =
      told_of(with_table(Strength::By::elevation,
                         {{2, 45}, {3, 20}, {4, 45}, {5, 8}, {6, 45}, {7, 90}, {8, 45}}),
              1);
  EXPECT_NE(told.find("falls to 8 kPa at"), std::string::npos) << told;
  EXPECT_NE(told.find("(and 3 more such)"), std::string::npos) << told;
}

TEST(SeenByParticles, ASeamOutsideTheMaterialIsNotTold) {
  Section s = with_table(Strength::By::elevation, {{2.76, 45}, {2.77, 8}, {3.23, 8}, {3.24, 45}});
  s.layers = {test::layer("clay"), test::layer("silt")};
  s.layers[0].bottom_m = 4;
  s.materials["silt"] = test::elastic_plastic();
  EXPECT_EQ(told_of(s, 1), "");
  s.layers[0].bottom_m = 3;  // cuts the seam
  EXPECT_NE(told_of(s, 1), "");
  s.layers[1].material = "clay";
  s.materials.erase("silt");
  EXPECT_NE(told_of(s, 1).find("at most 0.92 m"), std::string::npos);
}

TEST(SeenByParticles, StrengthThatOnlyGrowsIsNotTold) {
  EXPECT_EQ(told_of(with_table(Strength::By::depth, {{0, 5}, {20, 60}}), 1), "");
}

TEST(SeenByParticles, AToeCutWithoutAParticleIsRefused) {
  Section s = test::bank();
  RunSettings settings = cells_of(2);
  settings.trigger = UndrainedTrigger{0.4};
  const auto faults = validate(s, settings);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].pointer, "/trigger/then_toe_cut_m");
  EXPECT_NE(faults[0].message.find("holds no particle"), std::string::npos) << faults[0].message;
  settings.trigger = UndrainedTrigger{4.0};
  EXPECT_TRUE(validate(s, settings).empty());
}

TEST(SeenByParticles, AToeCutIntoAVerticalFaceIsRefused) {
  Section s = test::bank();
  s.ground = {{0, 20}, {40, 20}, {40, 5}, {100, 5}};
  s.crest = Point{40, 20};
  s.toe = Point{40, 5};
  RunSettings settings = cells_of(1);
  EXPECT_TRUE(validate(s, settings).empty());
  settings.trigger = UndrainedTrigger{3.0};
  const auto faults = validate(s, settings);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_NE(faults[0].message.find("no ground lies in front"), std::string::npos)
      << faults[0].message;
}

TEST(SeenByParticles, ASlabOfAnExcavationIsRefusedOrTold) {
  const Section s = test::bank();
  RunSettings settings = cells_of(1);
  const auto slab = [&](double bottom, double top) {
    settings.trigger = ExcavationTrigger{{{5, bottom}, {15, bottom}, {15, top}, {5, top}}};
  };
  slab(19.8, 25);  // the uppermost row stands at 19.75
  auto faults = validate(s, settings);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].pointer, "/trigger/polygon");
  slab(19.7, 25);
  EXPECT_TRUE(validate(s, settings).empty());
  EXPECT_NE(text(warnings_of(s, settings)).find("the excavation is 0.3 m thick"),
            std::string::npos);
  slab(18, 25);
  EXPECT_EQ(text(warnings_of(s, settings)).find("excavation"), std::string::npos);
}

TEST(SeenByParticles, ABankOfFewCellsIsToldAndOfOneRefused) {
  const Section s = test::bank();  // 15 m high
  EXPECT_TRUE(warnings_of(s, cells_of(1)).empty());
  EXPECT_NE(text(warnings_of(s, cells_of(3))).find("the bank is 5 cells high"), std::string::npos);
  EXPECT_TRUE(validate(s, cells_of(7.4)).empty());
  const auto faults = validate(s, cells_of(8));
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_NE(faults[0].message.find("half of the height of the bank (15 m)"), std::string::npos);
}

}  // namespace
}  // namespace leda
