#include "server/documents/study_document.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "server/drawings/study_drawing.hpp"
#include "tests/server/documents/some_study.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(StudyDocument, HoldsRunsSettingsAndTheFastest) {
  const json document = to_document(test::some_study());
  EXPECT_EQ(document["machine"], "a machine");
  EXPECT_EQ(document["date"], "2026-01-31T12:00:00.000Z");
  ASSERT_EQ(document["runs"].size(), 4U);
  EXPECT_EQ(document["runs"][1]["name"], "cell-1-particles-4-seed-1");
  EXPECT_DOUBLE_EQ(document["runs"][1]["runout_error"], 0.1);
  EXPECT_DOUBLE_EQ(document["runs"][1]["error"], 0.2);
  ASSERT_EQ(document["settings"].size(), 2U);
  EXPECT_DOUBLE_EQ(document["settings"][0]["crest_to_crest_retrogression_m"]["mean"], 10.2);
  EXPECT_EQ(document["settings"][0]["error"]["both"]["mean_and_spread_within"], true);
  EXPECT_EQ(document["settings"][1]["error"]["both"]["mean_within"], false);
  const json& fastest = document["fastest_within_wanted_error"];
  EXPECT_EQ(fastest["both"]["by_mean"]["cell_m"], 0.5);
  EXPECT_EQ(fastest["runout"]["by_mean"]["cell_m"], 1);
  EXPECT_DOUBLE_EQ(fastest["both"]["by_mean"]["cost_s"], 16.5);
}

TEST(StudyDocument, SaysWhatItComesTo) {
  const auto outcome = study_outcome(test::some_study());
  ASSERT_EQ(outcome.size(), 5U);
  EXPECT_EQ(outcome[0],
            "fastest setting within 10.0 % in retrogression and runout: 0.5 m, 4 particles (error "
            "2.0 %, 16.5 s), with its spread over seeds too");
  // At 1 m the runout is 5 % off with a standard deviation of 7 %.
  EXPECT_EQ(outcome[2],
            "fastest setting within 10.0 % in runout alone: 1 m, 4 particles (error 5.0 %, 2.1 s); "
            "with its spread over seeds: 0.5 m, 4 particles (error 1.0 %, 16.5 s)");
  EXPECT_NE(study_table(test::some_study()).find("0.5 m, 4 particles"), std::string::npos);
}

TEST(StudyDocument, ARunWithoutAResultHasItsReason) {
  Study study = test::some_study();
  auto runs = study.runs;
  runs[0].result.reset();
  runs[0].reason = "the worker died, \"early\"";
  study = conclude(study.asked, runs, study.date);
  const json document = to_document(study);
  EXPECT_EQ(document["runs"][0]["status"], "no-result");
  EXPECT_EQ(document["runs"][0]["reason"], "the worker died, \"early\"");
  EXPECT_TRUE(document["runs"][0]["error"].is_null());
  EXPECT_EQ(document["settings"][1]["runs_with_result"], 1);
  EXPECT_TRUE(
      document["settings"][1]["crest_to_crest_retrogression_m"]["standard_deviation"].is_null());
  EXPECT_NE(study_csv(study).find("1,4,0,no-result,,,,,,,,,,,,,\"the worker died, \"\"early\"\"\""),
            std::string::npos)
      << study_csv(study);
}

TEST(StudyDocument, EveryLineOfTheTableOfRunsHasAllColumns) {
  Study study = test::some_study();
  study.runs[2].result.reset();
  study = conclude(study.asked, study.runs, study.date);
  const std::string csv = study_csv(study);
  EXPECT_EQ(count(csv, "\r\n"), 5U);
  std::size_t begin = 0;
  for (auto end = csv.find("\r\n"); end != std::string::npos; end = csv.find("\r\n", begin)) {
    const std::string line = csv.substr(begin, end - begin);
    EXPECT_EQ(std::ranges::count(line, ','), 16) << line;
    begin = end + 2;
  }
}

TEST(StudyDrawing, HasAPanelADistanceAndAMarkASetting) {
  const std::string svg = study_svg(test::some_study());
  EXPECT_EQ(count(svg, "error of retrogression (%)"), 1U);
  EXPECT_EQ(count(svg, "error of runout (%)"), 1U);
  EXPECT_NE(svg.find("field &lt;1994&gt;"), std::string::npos);
  EXPECT_EQ(count(svg, ">wanted error<"), 2U);
  // Two settings in two panels, two marks of the legend.
  EXPECT_EQ(count(svg, "stroke-width=\"1.8\""), 6U);
  EXPECT_EQ(count(svg, "nan"), 0U);
  EXPECT_EQ(count(svg, "inf"), 0U);
}

TEST(StudyDrawing, OneDistanceIsOnePanel) {
  json inputs = test::study_inputs();
  inputs["reference"].erase("runout_m");
  const Study whole = test::some_study();
  const std::string svg = study_svg(conclude(test::study_asked(inputs), whole.runs, whole.date));
  EXPECT_EQ(count(svg, "error of retrogression (%)"), 1U);
  EXPECT_EQ(count(svg, "error of runout (%)"), 0U);
}

TEST(StudyDrawing, NothingToCompareAndErrorsOfZeroAreDrawnToo) {
  json inputs = test::study_inputs();
  inputs["reference"] = "finest";
  const Study whole = test::some_study();
  auto runs = whole.runs;
  for (auto& run : runs) run.result->crest_to_crest_retrogression_m = 10;
  const std::string same = study_svg(conclude(test::study_asked(inputs), runs, whole.date));
  EXPECT_EQ(count(same, "nan"), 0U);
  EXPECT_EQ(count(same, "inf"), 0U);
  for (auto& run : runs) run.result.reset();
  const std::string none = study_svg(conclude(test::study_asked(inputs), runs, whole.date));
  EXPECT_EQ(count(none, "nothing to compare"), 1U);
  EXPECT_EQ(count(none, "nan"), 0U);
}

}  // namespace
}  // namespace leda::server
