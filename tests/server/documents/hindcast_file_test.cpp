#include "server/documents/hindcast_file.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "server/documents/hindcast_document.hpp"
#include "server/documents/published_schema.hpp"
#include "server/drawings/hindcast_drawing.hpp"
#include "tests/server/documents/read_data.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using Pointers = std::multiset<std::string>;

json event(const char* name, const char* case_file, json observed) {
  return {{"name", name},
          {"case", json::parse(test::read_case(case_file))},
          {"observed", std::move(observed)}};
}

json hindcast() {
  return {{"name", "two banks"},
          {"events",
           {event("A", "sainte-monique-AA.json",
                  {{"retrogression_m", {{"value", 100}, {"sd_ln", 0.05}}},
                   {"runout_m", {{"at_least", 40}, {"at_most", 60}}}}),
            event("B", "small-bank.json", {{"retrogression_m", {{"at_least", 5}}}})}},
          {"ensemble",
           {{"inputs",
             {{{"name", "su"},
               {"path", "/materials/*/peak_strength_kPa"},
               {"apply", "scale"},
               {"scope", "section"},
               {"distribution", {{"type", "lognormal"}, {"mean", 1}, {"cov", 0.15}}}},
              {{"name", "remolded"},
               {"path", "/materials/*/softening/remolded_strength_kPa"},
               {"apply", "scale"},
               {"scope", "region"},
               {"distribution", {{"type", "uniform"}, {"min", 0.8}, {"max", 1.2}}}}}}}},
          {"members", 16}};
}

Parsed<HindcastFile> parsed(const json& inputs) {
  return parse_hindcast_request(json{{"inputs", inputs}}.dump());
}

Pointers faults(const json& inputs) { return test::pointers(parsed(inputs).faults); }
std::string text(const json& inputs) { return test::text(parsed(inputs).faults); }

TEST(HindcastFile, RunsAreCasesOfTheirSlideWithSharedInputs) {
  const auto read = parsed(hindcast());
  ASSERT_TRUE(read) << test::text(read.faults);
  const HindcastFile& file = *read.value;
  const solver::SharedDraws draws(file.plan.draws);
  const auto runs = runs_of_draw(file.plan, 0, 0);
  ASSERT_EQ(runs.size(), 2U * 16U);
  const json a = file.case_of(draws, {0, 3, 0}), b = file.case_of(draws, {1, 3, 0});
  const auto inputs = file.inputs_of(draws, {0, 3, 0});
  EXPECT_EQ(a["name"], "A wave-1-slide-1-member-3");
  EXPECT_EQ(a["materials"]["S1"]["peak_strength_kPa"], 40.5 * inputs[0]);
  EXPECT_EQ(b["materials"]["clay"]["softening"]["remolded_strength_kPa"], 1 * inputs[1]);
  EXPECT_NE(b["materials"]["clay"]["peak_strength_kPa"], 20 * inputs[0]) << "su is of each slide";
  EXPECT_FALSE(b.contains("output"));
  EXPECT_NE(a["resolution"]["seed"], b["resolution"]["seed"]);
  std::set<std::string> names;
  for (std::size_t wave = 0; wave < 2; ++wave) {
    for (std::size_t local = 0; local < 4; ++local) {
      for (const auto& run : runs_of_draw(file.plan, wave, local)) {
        names.insert(run_name(file.plan.draws, run));
      }
    }
  }
  EXPECT_EQ(names.size(), 256U);
}

TEST(HindcastFile, WhatIsNotSaidIsAsDocumented) {
  const auto plan = parsed(hindcast()).value->plan;
  EXPECT_EQ(plan.waves, 2U);
  EXPECT_EQ(plan.draws.locals, 4U);
  EXPECT_EQ(plan.draws.seed, 1U);
  EXPECT_EQ(plan.least_effective, 8);
  EXPECT_EQ(plan.discrepancy.sd_ln, 0.3);
  EXPECT_EQ(plan.discrepancy.correlation, 0.5);
  EXPECT_EQ(plan.discrepancy.bias_sd_ln, 0);
  EXPECT_EQ(plan.slides[0].runout->at_most_m, 60);
  EXPECT_EQ(plan.slides[1].least_m, 1) << "its cell";
}

TEST(HindcastFile, FaultsOfWhatWasObservedComeAllAtOnce) {
  json bad = hindcast();
  bad["events"][0]["observed"] = {{"retrogression_m", {{"value", -5}, {"sd_ln", 9}}},
                                  {"runout_m", {{"value", 50}, {"sd_ln", 0.1}, {"at_least", 40}}},
                                  {"depth_m", 3}};
  bad["events"][1]["observed"] = {{"retrogression_m", {{"at_least", 60}, {"at_most", 40}}},
                                  {"runout_m", json::object()}};
  EXPECT_EQ(faults(bad), (Pointers{"/inputs/events/0/observed/depth_m",
                                   "/inputs/events/0/observed/retrogression_m/sd_ln",
                                   "/inputs/events/0/observed/retrogression_m/value",
                                   "/inputs/events/0/observed/runout_m",
                                   "/inputs/events/1/observed/retrogression_m/at_most",
                                   "/inputs/events/1/observed/runout_m"}))
      << text(bad);
  bad = hindcast();
  bad["events"][0]["observed"] = {{"retrogression_m", {{"value", 50}}}};
  bad["events"][1]["observed"] = {{"runout_m", {{"at_least", 50}, {"sd_ln", 0.1}}}};
  EXPECT_EQ(faults(bad), (Pointers{"/inputs/events/0/observed/retrogression_m/sd_ln",
                                   "/inputs/events/1/observed/runout_m/sd_ln"}));
  bad["events"][0]["observed"] = json::object();
  bad["events"][1].erase("observed");
  EXPECT_EQ(faults(bad), (Pointers{"/inputs/events/0/observed", "/inputs/events/1/observed"}));
}

TEST(HindcastFile, WeightsThatDoNotAddUpAreAFaultBesideAllOthers) {
  json bad = hindcast();
  bad["ensemble"]["inputs"][1]["distribution"] = {
      {"type", "sample"}, {"set", "before"}, {"values", {0.9, 1.1}}, {"weights", {0.5, 0.6}}};
  bad["ensemble"]["stop"] = {{"min_members", 64}};
  bad["events"][1]["name"] = "A";
  bad["discrepancy"] = {{"sd_ln", 0}, {"correlation", 1}, {"bias_sd_ln", -1}, {"scale", 2}};
  bad["members"] = 8;
  bad["waves"] = 0;
  bad["confidence"] = 1;
  bad["events"][0]["case"]["resolution"]["cell_m"] = -1;
  EXPECT_EQ(faults(bad),
            (Pointers{"/inputs/confidence", "/inputs/discrepancy/bias_sd_ln",
                      "/inputs/discrepancy/correlation", "/inputs/discrepancy/scale",
                      "/inputs/discrepancy/sd_ln", "/inputs/ensemble/inputs/1/distribution/weights",
                      "/inputs/ensemble/stop", "/inputs/events/0/case/resolution/cell_m",
                      "/inputs/events/1/name", "/inputs/members", "/inputs/waves"}))
      << text(bad);
}

TEST(HindcastFile, SomethingMustBeShared) {
  json bad = hindcast();
  bad["ensemble"]["inputs"][1]["scope"] = "section";
  EXPECT_EQ(faults(bad), (Pointers{"/inputs/ensemble/inputs"})) << text(bad);
}

TEST(HindcastFile, AnInputMustLeadSomewhereAtEverySlide) {
  json bad = hindcast();
  bad["ensemble"]["inputs"][0]["path"] = "/materials/S1/peak_strength_kPa";
  EXPECT_EQ(faults(bad), (Pointers{"/inputs/ensemble/inputs/0/path"}));
  EXPECT_NE(text(bad).find("at B: "), std::string::npos) << text(bad);
}

TEST(HindcastFile, AMemberThatCannotBeRunIsToldBeforeAnyIs) {
  json bad = hindcast();
  bad["ensemble"]["inputs"][0]["distribution"] = {{"type", "uniform"}, {"min", -1}, {"max", 1}};
  const std::string told = text(bad);
  EXPECT_EQ(faults(bad).count("/inputs/ensemble/inputs/0/distribution"), 2U) << told;
  EXPECT_NE(told.find("at A, wave-1-slide-1-member-"), std::string::npos) << told;
  EXPECT_NE(told.find("at B, wave-1-slide-2-member-"), std::string::npos) << told;
}

TEST(HindcastFile, TooManyRunsAreRefused) {
  json bad = hindcast();
  bad["members"] = 4096;
  bad["waves"] = 3;
  EXPECT_EQ(faults(bad), (Pointers{"/inputs/members"})) << text(bad);
}

TEST(HindcastFile, OnTheCommandLineACaseMayBeAFile) {
  json document = hindcast();
  document["events"][1].erase("case");
  document["events"][1]["case_file"] = "bank.json";
  const auto read = [&](const std::string& name) {
    return name == "bank.json" ? std::optional(test::read_case("small-bank.json")) : std::nullopt;
  };
  const auto file = parse_hindcast_file(document.dump(), read);
  ASSERT_TRUE(file) << test::text(file.faults);
  EXPECT_EQ(file.value->cases[1].of.settings.resolution.cell_m, 1);
  EXPECT_EQ(faults(document), (Pointers{"/inputs/events/1/case", "/inputs/events/1/case_file"}))
      << "over HTTP there is no file";
  document["events"][1]["case_file"] = "other.json";
  EXPECT_EQ(test::pointers(parse_hindcast_file(document.dump(), read).faults),
            (Pointers{"/events/1/case_file"}));
}

TEST(HindcastFile, TheLandslidesOfTheValidationAreSound) {
  const auto file =
      parse_hindcast_file(test::read_case("../../validation/hindcast/HINDCAST.json"),
                          [](const std::string&) { return std::optional<std::string>(); });
  ASSERT_TRUE(file) << test::text(file.faults);
  EXPECT_EQ(file.value->cases.size(), 4U);
}

TEST(HindcastFile, ThePriorOfTheValidationIsTakenByAnEnsembleAndToldToBeOfFewSlides) {
  const json prior = json::parse(test::read_case("../../validation/hindcast/prior.json"));
  FaultList found;
  const auto request = read_ensemble({{"inputs", prior["inputs"]}}, "", found);
  EXPECT_EQ(test::text(found.take()), "");
  EXPECT_EQ(request.plan.inputs.size(), 3U);
  const std::string label = prior["label"];
  EXPECT_NE(label.find("after 4 past slides alone"), std::string::npos) << label;
  EXPECT_NE(label.find("not to be trusted"), std::string::npos) << label;
}

/// Members' runs without a simulation: retrogression grows with what is shared.
struct MadeUp {
  explicit MadeUp(const json& inputs)
      : file(*parsed(inputs).value), draws(file.plan.draws), rows(rows_of_all()) {}

  std::vector<HindcastRow> rows_of_all() const {
    std::vector<HindcastRow> all;
    for (const auto& run : runs_of_draw(file.plan, 0, 0)) {
      SectionResult result;
      result.status = RunStatus::at_rest;
      result.crest_to_crest_retrogression_m = 100 * file.inputs_of(draws, run)[1];
      result.runout_m = 50;
      result.run_time_s = 2;
      all.push_back(row_of(file, draws, run, result));
    }
    return all;
  }

  Hindcast hindcast() const {
    return {file, draws, rows, solver::summarize(file.plan, draws, outcomes_of(file, draws, rows))};
  }

  HindcastFile file;
  solver::SharedDraws draws;
  std::vector<HindcastRow> rows;
};

TEST(HindcastDocument, SaysWhatWasAskedForAndOnWhatItIsConditional) {
  const MadeUp made(hindcast());
  const json document = to_document(made.hindcast());
  EXPECT_EQ(document["members"], 16);
  EXPECT_EQ(document["core_s"], 64);
  EXPECT_EQ(document["condition"], hindcast_condition);
  EXPECT_EQ(document["shared_inputs"].size(), 1U);
  EXPECT_EQ(document["slides"].size(), 2U);
  EXPECT_EQ(document["slides"][0]["retrogression"]["observed"]["value"], 100);
  EXPECT_EQ(document["slides"][0]["retrogression"]["predicted"]["hit"], true);
  EXPECT_EQ(document["slides"][1]["retrogression"]["predicted"]["hit"], nullptr);
  EXPECT_EQ(document["retrogression"]["hits"], 1);
  EXPECT_EQ(document["retrogression"]["of"], 1);
  EXPECT_EQ(document["retrogression"]["chance_of_so_few"], 1);
  EXPECT_TRUE(document["weights"]["trusted"]);
  const std::string label = document["posterior"]["label"];
  EXPECT_NE(label.find("after 2 past slides alone (A, B)"), std::string::npos) << label;
}

TEST(HindcastDocument, ItsPosteriorIsTakenByAnEnsembleAsItStands) {
  const MadeUp made(hindcast());
  const json inputs = to_document(made.hindcast())["posterior"]["inputs"];
  ASSERT_EQ(inputs.size(), 1U);
  FaultList found;
  const auto request = read_ensemble({{"inputs", inputs}}, "", found);
  EXPECT_EQ(test::text(found.take()), "");
  EXPECT_TRUE(schema_faults(PublishedSchema::ensemble, {{"inputs", inputs}}).empty());
  const auto& sample = std::get<solver::JointSample>(request.plan.inputs[0].distribution);
  EXPECT_EQ(sample.values.size(), 16U);
  EXPECT_EQ(request.plan.inputs[0].scope, solver::Scope::region);
  EXPECT_EQ(request.places[0].path, "/materials/*/softening/remolded_strength_kPa");
}

TEST(HindcastDocument, AMemberIsDrawnAgainWhereItDidNotSlide) {
  MadeUp made(hindcast());
  const auto again = runs_of_draw(made.file.plan, 0, 1);
  EXPECT_TRUE(still_wanted(again, made.rows).empty());
  made.rows[4].result->crest_to_crest_retrogression_m = 0;
  made.rows[7].result.reset();
  const auto wanted = still_wanted(again, made.rows);
  ASSERT_EQ(wanted.size(), 2U);
  EXPECT_EQ(wanted[0], (solver::HindcastRun{made.rows[4].run.slide, made.rows[4].run.member, 1}));
  SectionResult slid = *made.rows[5].result;
  made.rows.push_back(row_of(made.file, made.draws, wanted[0], slid));
  const auto outcomes = outcomes_of(made.file, made.draws, made.rows);
  EXPECT_EQ(outcomes[wanted[0].slide][wanted[0].member].size(), 2U);
  EXPECT_GT(made.hindcast().summary.posterior.values[wanted[0].member], 0);
}

TEST(HindcastDocument, AnswersAreThePriorOfAnotherHindcast) {
  const MadeUp made(hindcast());
  json next = hindcast();
  const json after = to_document(made.hindcast())["posterior"]["inputs"][0];
  next["ensemble"]["inputs"][1] = after;
  const auto read = parsed(next);
  EXPECT_TRUE(read) << test::text(read.faults);
}

TEST(HindcastDocument, CsvHasALineARunWithWeightsOfItsMember) {
  const MadeUp made(hindcast());
  const std::string csv = members_csv(made.hindcast());
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 32);
  EXPECT_TRUE(
      csv.starts_with("slide,wave,member,local,prior_weight,weight,su,remolded,seed,status"))
      << csv;
  EXPECT_NE(csv.find("\"B\",1,15,1,0.0625,"), std::string::npos) << csv;
}

TEST(HindcastDocument, DrawingAndTableShowEachSlideAndInput) {
  json inputs = hindcast();
  inputs["events"][0]["name"] = "A & <C>";
  const MadeUp made(inputs);
  const std::string svg = hindcast_svg(made.hindcast());
  EXPECT_TRUE(svg.starts_with("<svg"));
  EXPECT_NE(svg.find("A &amp; &lt;C&gt;, retrogression"), std::string::npos);
  EXPECT_NE(svg.find("remolded: moved by"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  const std::string table = hindcast_table(made.hindcast());
  EXPECT_NE(table.find("at least 5"), std::string::npos) << table;
  EXPECT_NE(table.find("40 to 60"), std::string::npos) << table;
  EXPECT_NE(table.find("retrogression: 1 of 1 within 90 %"), std::string::npos) << table;
}

TEST(HindcastDocument, WhereNoMemberSlidItSaysSoAndHasNoPosterior) {
  MadeUp made(hindcast());
  for (HindcastRow& row : made.rows) row.result->crest_to_crest_retrogression_m = 0;
  const json document = to_document(made.hindcast());
  EXPECT_FALSE(document["weights"]["trusted"]);
  EXPECT_TRUE(document["posterior"]["inputs"].empty());
  EXPECT_EQ(document["slides"][0]["retrogression"]["predicted"], nullptr);
  EXPECT_TRUE(hindcast_svg(made.hindcast()).starts_with("<svg"));
  EXPECT_FALSE(hindcast_table(made.hindcast()).empty());
}

}  // namespace
}  // namespace leda::server
