// The table of the seven sites in solver/screening/README.md stands there as computed here.

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <sstream>

#include "solver/screening/analytics.hpp"
#include "tests/screening/banks.hpp"

namespace leda::solver {
namespace {

std::string cell(int decimals, const std::optional<double>& value) {
  if (!value) return "refused";
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, *value);
  return text;
}

std::string printed(const test::Row& row, const char* column) {
  return row.text(column).empty() ? "N/A" : row.text(column);
}

/// One line: printed / reproduced / right.
std::string line_of(std::size_t i) {
  const auto site_row = test::table("thesis_tables_3_3_3_4.csv")[i];
  const auto energy_row = test::table("thesis_table_3_5.csv")[i];
  const auto distance_row = test::table("thesis_table_3_7.csv")[i];
  Site site = test::site_of_row(site_row);
  site.slope_angle_deg = distance_row["slope_angle_deg"];
  const Analytics a = analyse(site);
  std::ostringstream line;
  line << "| " << site_row.text("site") << " | " << energy_row.text("remolding_energy") << " | "
       << cell(2, *a.remolding.thesis_reading / 1000) << " | "
       << cell(2, *a.remolding.complete_curve / 1000) << " | "
       << cell(2, *a.remolding.leroueil / 1000) << " | " << cell(2, *a.remolding.linear / 1000)
       << " | " << distance_row.text("observed") << " | " << printed(distance_row, "eq_3_22")
       << " | " << cell(1, a.retrogression.urmi_2023_thesis) << " | "
       << cell(1, a.retrogression.urmi_2023_corrected);
  if (const auto& range = a.retrogression.urmi_2023_corrected_range) {
    line << " (" << cell(0, range->at(0)) << " to " << cell(0, range->at(1)) << ")";
  }
  line << " |";
  return line.str();
}

TEST(SevenSites, TableOfTheReadmeIsComputed) {
  std::ifstream in(LEDA_SCREENING_README);
  std::stringstream readme;
  readme << in.rdbuf();
  for (std::size_t i = 0; i < 7; ++i) {
    const std::string line = line_of(i);
    EXPECT_NE(readme.str().find(line), std::string::npos) << "not in the README:\n" << line;
  }
}

}  // namespace
}  // namespace leda::solver
