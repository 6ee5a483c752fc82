#include "server/layers/section_table.hpp"

#include <gtest/gtest.h>

namespace leda::server {
namespace {

TEST(SectionTable, ShowsDistancesOrTheReasonTheyAreMissing) {
  std::vector<db::SectionRecord> sections(2);
  sections[0].name = "AA'";
  sections[0].state = db::SectionState::finished;
  SectionResult& result = sections[0].result.emplace();
  result.status = RunStatus::at_rest;
  result.crest_to_crest_retrogression_m = 103.25;
  result.runout_m = 52.44;
  result.run_time_s = 40;
  sections[1].name = "S001";
  sections[1].state = db::SectionState::left_out;
  sections[1].reason = "no data";

  const std::string table = section_table(sections);
  EXPECT_NE(table.find("AA'          at-rest                103.2      52.4        40.0"),
            std::string::npos)
      << table;
  EXPECT_NE(table.find("no data"), std::string::npos);
}

TEST(SectionTable, TellsEveryWarningWithItsSections) {
  std::vector<db::SectionRecord> sections(3);
  sections[0].name = "AA'";
  sections[0].warnings = {"the line bends"};
  sections[0].result.emplace().warnings = {"the front reached the edge", "the bank is low"};
  sections[0].placed.emplace().known = true;
  sections[0].placed->warnings = {"the line bends", "the debris runs beyond the section"};
  sections[1].name = "BB'";
  sections[1].state = db::SectionState::stable;
  sections[1].reason = "screened: stable";
  sections[1].warnings = {"the line bends", "the DEM is coarse"};
  sections[2].name = "CC'";
  sections[2].warnings = {"the line bends"};

  const std::string table = section_table(sections);
  EXPECT_NE(table.find("screened: stable\n"), std::string::npos) << table;
  EXPECT_TRUE(
      table.ends_with("warning: AA': the front reached the edge\n"
                      "warning: AA': the bank is low\n"
                      "warning: AA', BB', CC': the line bends\n"
                      "warning: AA': the debris runs beyond the section\n"
                      "warning: BB': the DEM is coarse\n"))
      << table;
}

}  // namespace
}  // namespace leda::server
