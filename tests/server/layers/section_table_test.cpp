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

}  // namespace
}  // namespace leda::server
