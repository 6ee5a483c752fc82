#include "server/documents/study_document.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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
  ASSERT_EQ(outcome.size(), 6U);
  EXPECT_EQ(outcome[0],
            "fastest setting within 10.0 % in retrogression and runout: 0.5 m, 4 particles (error "
            "2.0 %, 16.5 s), with its spread over seeds too");
  // At 1 m the runout is 5 % off with a standard deviation of 7 %.
  EXPECT_EQ(outcome[2],
            "fastest setting within 10.0 % in runout alone: 1 m, 4 particles (error 5.0 %, 2.1 s); "
            "with its spread over seeds: 0.5 m, 4 particles (error 1.0 %, 16.5 s)");
  EXPECT_NE(study_table(test::some_study()).find("0.5 m, 4 particles"), std::string::npos);
}

TEST(StudyDocument, TellsTheTimeStepOfEverySettingAndRun) {
  const Study study = test::study_of_steps();
  const json document = to_document(study);
  EXPECT_EQ(document["runs"][0]["name"], "cell-1-particles-4-step-0.9-seed-0");
  EXPECT_EQ(document["runs"][2]["name"], "cell-1-particles-4-seed-0");
  EXPECT_EQ(document["runs"][0]["time_step_factor"], 0.9);
  EXPECT_EQ(document["settings"][0]["time_step_factor"], 0.65);
  EXPECT_EQ(document["settings"][0]["particles_per_cell"].dump(), "4");
  EXPECT_EQ(document["fastest_within_wanted_error"]["runout"]["by_mean"]["time_step_factor"], 0.9);
  EXPECT_TRUE(study_csv(study).starts_with("cell_m,particles_per_cell,time_step_factor,seed,"));
  EXPECT_NE(study_csv(study).find("\r\n1,4,0.9,1,at-rest,11.4,5,"), std::string::npos);
  // Columns stay under their titles though the names are long.
  const std::string table = study_table(study);
  EXPECT_NE(table.find("1 m, 4 particles, step 0.9     2 "), std::string::npos) << table;
  EXPECT_NE(study_outcome(study)[2].find("1 m, 4 particles, step 0.9 (error"), std::string::npos);
}

TEST(StudyDocument, ANameIsSilentOfATimeStepThatIsTheCasesOwn) {
  EXPECT_EQ(study_table(test::some_study()).find("step 0"), std::string::npos);
  json inputs = test::study_inputs();
  inputs["time_step_factor"] = {0.65};
  const Study old = test::some_study();
  const Study asked = conclude(test::study_asked(inputs), old.runs, old.date);
  EXPECT_EQ(to_document(asked), to_document(old));
  EXPECT_EQ(study_table(asked), study_table(old));
  EXPECT_EQ(study_svg(asked), study_svg(old));
}

TEST(StudyDocument, SaysHowFarTheAnswerDependsOnEachAxisAndOnTheSeed) {
  const Study study = test::study_of_steps();
  const json dependence = to_document(study)["dependence"];
  const json& step = dependence["time_step_factor"];
  EXPECT_NEAR(step["retrogression"]["difference_m"], 0.6, 1e-12);
  EXPECT_NEAR(step["retrogression"]["share"], 0.6 / 11.7, 1e-12);
  EXPECT_EQ(step["retrogression"]["settings"], 2);
  EXPECT_NEAR(step["runout"]["difference_m"], 0.25, 1e-12);
  EXPECT_TRUE(dependence["cell_m"]["retrogression"].is_null());
  EXPECT_TRUE(dependence["particles_per_cell"]["runout"].is_null());
  EXPECT_NEAR(dependence["seed"]["runout"]["standard_deviation_m"], std::sqrt(0.125 / 2), 1e-12);
  EXPECT_EQ(dependence["seed"]["retrogression"]["standard_deviation_m"], 0);
  EXPECT_EQ(to_document(study)["settings"][0]["dependence"]["time_step_factor"], step);
  EXPECT_EQ(study_outcome(study).back(),
            "the answer depends (largest difference of means along one axis, the others held; "
            "seed: standard deviation) in retrogression on cells not compared, particles not "
            "compared, time step 0.6 m (5.1 %), seed 0.0 m (0.0 %); in runout on cells not "
            "compared, particles not compared, time step 0.2 m (4.9 %), seed 0.2 m (4.9 %)");
  const std::string table = study_table(study);
  EXPECT_NE(table.find("depends on time step                   0.6 (5.1 %)     0.2 (4.9 %)\n"),
            std::string::npos)
      << table;
  EXPECT_NE(table.find("depends on cells                                 -               -\n"),
            std::string::npos)
      << table;
}

TEST(StudyDocument, ARunSaysWhichOfItsDistancesAreBounds) {
  Study study = test::some_study();
  study.runs[1].result->runout_is = Bound::lower_bound;
  const json run = to_document(study)["runs"][1];
  EXPECT_EQ(run["retrogression_is"], "measured");
  EXPECT_EQ(run["runout_is"], "lower-bound");
  const std::string csv = study_csv(study);
  EXPECT_NE(csv.find(",runout_m,retrogression_is,runout_is,slides,"), std::string::npos) << csv;
  EXPECT_EQ(count(csv, ",measured,lower-bound,"), 1U) << csv;
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
  EXPECT_NE(study_csv(study).find(
                "1,4,0.65,0,no-result,,,,,,,,,,,,,,,\"the worker died, \"\"early\"\"\""),
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
    EXPECT_EQ(std::ranges::count(line, ','), 19) << line;
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

TEST(StudyDrawing, MarksAreAsLargeAsTheTimeStepIsLong) {
  const std::string svg = study_svg(test::study_of_steps());
  EXPECT_EQ(count(svg, ">time step factor<"), 1U);
  EXPECT_EQ(count(svg, ">0.65<"), 1U);
  EXPECT_EQ(count(svg, ">0.9<"), 1U);
  // Squares of 1.7 times their size: each in two panels, and in the legend.
  EXPECT_EQ(count(svg, "h-7.649"), 3U) << svg;
  EXPECT_EQ(count(svg, "h-15.29"), 3U) << svg;
  EXPECT_EQ(count(study_svg(test::some_study()), "time step"), 0U);
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
