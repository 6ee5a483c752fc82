#include "server/documents/member_warnings.hpp"

#include <gtest/gtest.h>

#include "server/documents/ensemble_document.hpp"
#include "tests/server/documents/read_data.hpp"
#include "tests/server/documents/some_study.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using Lines = std::vector<std::string>;

Lines lines_of_members(const std::vector<Lines>& warnings, const Lines& base) {
  GatheredWarnings gathered;
  for (std::size_t m = 0; m < warnings.size(); ++m) gathered.add(std::to_string(m), warnings[m]);
  return member_lines(gathered, warnings.size(), base);
}

TEST(MemberWarnings, TellWhatTheBaseIsNotWarnedOf) {
  EXPECT_EQ(
      lines_of_members({{"is coarse"}, {"is coarse", "is dry"}, {"is dry"}, {}}, {"is coarse"}),
      (Lines{"2 of 4 members: is dry"}));
  EXPECT_TRUE(lines_of_members({{"is coarse"}, {}}, {"is coarse"}).empty());
}

TEST(MemberWarnings, TextsThatDifferInMeasuredNumbersAloneAreOneLine) {
  EXPECT_EQ(lines_of_members({{"layer 1 (S1) is 0.83 m thick and acts as 1 m"},
                              {"layer 1 (S1) is 0.4 m thick and acts as 0.5 m"},
                              {"layer 2 (S1) is 0.4 m thick and acts as 0.5 m"},
                              {"layer 1 (S2) is 0.4 m thick and acts as 0.5 m"}},
                             {}),
            (Lines{"2 of 4 members, such as: layer 1 (S1) is 0.83 m thick and acts as 1 m",
                   "1 of 4 members: layer 2 (S1) is 0.4 m thick and acts as 0.5 m",
                   "1 of 4 members: layer 1 (S2) is 0.4 m thick and acts as 0.5 m"}));
}

/// Of three members, the first one's other seed and finer cells, and a member beyond them.
TEST(MemberWarnings, OfAnEnsembleAreThoseOfTheMembersThatCount) {
  std::vector<MemberRow> rows;
  const std::vector<MemberRun> runs{{0}, {1}, {2}, {0, 1}, {0, 0, true}, {3}};
  for (const MemberRun& run : runs) {
    MemberRow& row = rows.emplace_back();
    row.run = run;
    row.result.emplace().warnings = {"is odd"};
  }
  rows[2].result.reset();
  EXPECT_EQ(member_lines(rows, 3, {}), (Lines{"2 of 3 members: is odd"}));
}

TEST(MemberWarnings, StandInTheEnsemblesDocumentAndTables) {
  SectionEnsemble ensemble{"AA'", {}, {}, {"the bank is low"}, {"2 of 3 members: is odd"}};
  for (const auto distance : solver::distances) ensemble.summary.by_distance[distance];
  EXPECT_EQ(to_document(ensemble)["warnings"], (json{"the bank is low", "2 of 3 members: is odd"}));
  EXPECT_TRUE(ensemble_table(ensemble).ends_with(
      "\nwarning: the bank is low\nwarning: 2 of 3 members: is odd\n"));
  EXPECT_TRUE(quantile_table({ensemble}).ends_with("\nwarning: AA': 2 of 3 members: is odd\n"));
}

json hindcast_of_one_bank() {
  const json event{{"name", "A"},
                   {"case", json::parse(test::read_case("small-bank.json"))},
                   {"observed", {{"retrogression_m", {{"at_least", 5}}}}}};
  const json input{{"name", "weight"},
                   {"path", "/materials/clay/unit_weight_kN_m3"},
                   {"scope", "region"},
                   {"distribution", {{"type", "uniform"}, {"min", 16}, {"max", 18}}}};
  return {{"name", "banks"},
          {"events", json::array({event})},
          {"ensemble", {{"inputs", json::array({input})}}},
          {"members", 16}};
}

TEST(MemberWarnings, OfAHindcastNameTheSlide) {
  const auto parsed = parse_hindcast_request(json{{"inputs", hindcast_of_one_bank()}}.dump());
  ASSERT_TRUE(parsed) << test::text(parsed.faults);
  const Lines before = hindcast_warnings(*parsed.value, {}, 0);
  ASSERT_FALSE(before.empty()) << "the small bank is a few cells high";
  EXPECT_TRUE(before[0].starts_with("A: the bank is ")) << before[0];

  std::vector<HindcastRow> rows(2);
  rows[1].run.member = 1;
  rows[1].run.local = 2;
  rows[1].result.emplace().warnings = {before[0].substr(3), "is odd"};
  Lines told = before;
  told.emplace_back("A: 1 of 16 members: is odd");
  EXPECT_EQ(hindcast_warnings(*parsed.value, rows, 16), told);
}

TEST(StudyWarnings, NameTheSettingsBeforeAndAfterTheRuns) {
  const Study study = test::some_study();
  const Lines before =
      study_warnings(study.asked, solver::study_runs(study.asked.question.settings));
  ASSERT_FALSE(before.empty()) << "the small bank is a few cells of 1 m high";
  EXPECT_TRUE(before[0].starts_with("1 m, 4 particles: the bank is ")) << before[0];

  const Lines after{"1 m, 4 particles; 0.5 m, 4 particles: front within two cells of the edge"};
  EXPECT_EQ(study_warnings(study.asked, study.runs), after);
  EXPECT_EQ(to_document(study)["warnings"], json(after));
  EXPECT_TRUE(study_table(study).ends_with("\nwarning: " + after[0] + "\n"));
}

}  // namespace
}  // namespace leda::server
