// CSV files of the laboratory: what is read and what is refused.

#include "solver/element_test/lab_curve.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace leda::solver {
namespace {

LabFile read(const std::string& text) {
  std::istringstream in(text);
  return read_lab_file(in);
}

TEST(LabFile, ReadsPercentAndKilopascal) {
  const LabFile file = read(
      "# Saint-Jude, DSS\n\nshear_strain_percent, shear_stress_kPa ,note\r\n0,0,a\r\n"
      "3, 55 ,peak\r\n10,44.5,\r\n");
  ASSERT_TRUE(file.faults.empty()) << file.faults.front();
  ASSERT_TRUE(file.stress_strain.has_value());
  EXPECT_FALSE(file.energy.has_value());
  ASSERT_EQ(file.stress_strain->strain.size(), 3U);
  EXPECT_DOUBLE_EQ(file.stress_strain->strain[1], 0.03);
  EXPECT_DOUBLE_EQ(file.stress_strain->stress_Pa[2], 44500);
}

TEST(LabFile, ReadsEnergyCurvesInAnyColumnOrder) {
  const LabFile file = read("\xEF\xBB\xBFremolding_index_percent,normalized_energy\n50,5\n90,15\n");
  ASSERT_TRUE(file.faults.empty()) << file.faults.front();
  ASSERT_TRUE(file.energy.has_value());
  EXPECT_DOUBLE_EQ(file.energy->remolding_index[1], 0.9);
  EXPECT_DOUBLE_EQ(file.energy->normalized_energy[0], 5);
}

TEST(LabFile, NamesEveryFaultWithItsLine) {
  const LabFile file = read("shear_strain,shear_stress_kPa\n0,0\n0.1,abc\n0.2\n0.05,-3\n0.3,inf\n");
  ASSERT_EQ(file.faults.size(), 5U);
  EXPECT_EQ(file.faults[0], "line 3: shear_stress_kPa is \"abc\", not a finite number");
  EXPECT_EQ(file.faults[1], "line 4: has 1 cells, the header 2");
  EXPECT_EQ(file.faults[2], "line 5: shear_strain goes back: rows must be in order");
  EXPECT_EQ(file.faults[3], "line 5: shear_stress_kPa is negative");
  EXPECT_EQ(file.faults[4], "line 6: shear_stress_kPa is \"inf\", not a finite number");
}

TEST(LabFile, RefusesAnEmptyFileAndAnUnknownHeader) {
  EXPECT_FALSE(read("").faults.empty());
  EXPECT_FALSE(read("# nothing\n").faults.empty());
  const LabFile file = read("strain,stress\n0,0\n");
  ASSERT_EQ(file.faults.size(), 1U);
  EXPECT_NE(file.faults[0].find("shear_strain_percent"), std::string::npos);
}

// 8,9 kPa under a header of two would be 8 kPa, and the fit would not tell.
TEST(LabFile, DecimalCommasAreRefused) {
  const LabFile file = read("shear_strain_percent,shear_stress_kPa\n1,8,9\n2,9\n");
  ASSERT_EQ(file.faults.size(), 1U);
  EXPECT_EQ(file.faults[0],
            "line 2: has 3 cells, the header 2: decimals are written with a point, not a comma");
}

TEST(LabFile, OtherWaysToWriteATableAreNamed) {
  const auto fault = [](const std::string& text) { return read(text).faults.at(0); };
  EXPECT_NE(fault("shear_strain;shear_stress_kPa\n0;0\n").find("semicolons"), std::string::npos);
  EXPECT_NE(fault("shear_strain\tshear_stress_kPa\n0\t0\n").find("tabs"), std::string::npos);
  EXPECT_NE(fault("\"shear_strain\",\"shear_stress_kPa\"\n0,0\n").find("quotes"),
            std::string::npos);
  EXPECT_NE(fault("\xFF\xFEs").find("UTF-16"), std::string::npos);
}

TEST(LabFile, AHostileFileGivesFewFaults) {
  std::string text = "shear_strain,shear_stress_kPa\n";
  for (int i = 0; i < 5000; ++i) text += "x,y\n";
  EXPECT_EQ(read(text).faults.size(), 20U);
}

}  // namespace
}  // namespace leda::solver
