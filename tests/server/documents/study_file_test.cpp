#include "server/documents/study_file.hpp"

#include <gtest/gtest.h>

#include "server/documents/published_schema.hpp"
#include "tests/server/documents/some_study.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using Pointers = std::multiset<std::string>;

Parsed<StudyFile> over_http(const json& inputs) {
  return parse_study_request(json{{"inputs", inputs}}.dump());
}

Parsed<StudyFile> as_file(const json& document) {
  return parse_study_file(document.dump(), [](const std::string& name) {
    return name == "bank.json" ? std::optional(test::read_case("small-bank.json")) : std::nullopt;
  });
}

Pointers faults_over_http(const json& inputs) { return test::pointers(over_http(inputs).faults); }

TEST(StudyFile, IsTheGridOfCellsAndParticlesAndWhatIsAskedBesideIt) {
  json inputs = test::study_inputs();
  inputs["particles_per_cell"] = {1, 9};
  inputs["also"] = {{{"cell_m", 0.4}, {"particles_per_cell", 4}, {"seeds", 0}}};
  const auto parsed = over_http(inputs);
  ASSERT_TRUE(parsed) << test::text(parsed.faults);
  const std::vector<solver::StudySetting> expected{
      {0.5, 1, 1}, {0.5, 9, 1}, {1, 1, 1}, {1, 9, 1}, {0.4, 4, 0}};
  EXPECT_EQ(parsed.value->question.settings, expected);
  EXPECT_EQ(parsed.value->question.reference->source, "field <1994>");
  EXPECT_EQ(parsed.value->machine, "a machine");
}

TEST(StudyFile, HasDefaults) {
  json inputs = test::study_inputs();
  for (const char* key : {"seeds", "wanted_error", "machine"}) inputs.erase(key);
  inputs["reference"] = "finest";
  const StudyFile study = over_http(inputs).value.value();
  EXPECT_EQ(study.question.settings[0].seeds, 3);
  EXPECT_EQ(study.question.wanted_error, 0.1);
  EXPECT_FALSE(study.question.reference);
  EXPECT_EQ(study.workers, 1);
}

TEST(StudyFile, ACaseFileAndWorkersAreOfTheCommandLineAlone) {
  json document = test::study_inputs();
  document.erase("case");
  document["case_file"] = "bank.json";
  document["workers"] = 2;
  const auto parsed = as_file(document);
  ASSERT_TRUE(parsed) << test::text(parsed.faults);
  EXPECT_EQ(parsed.value->workers, 2);
  EXPECT_EQ(case_sha256(parsed.value->of),
            case_sha256(*parse_case_file(test::read_case("small-bank.json")).value));
  EXPECT_EQ(faults_over_http(document),
            (Pointers{"/inputs/case", "/inputs/case_file", "/inputs/workers"}));
}

TEST(StudyFile, FaultsOfTheCaseFileNameTheFile) {
  json document = test::study_inputs();
  document["case_file"] = "bank.json";
  EXPECT_EQ(test::pointers(as_file(document).faults), Pointers{"/case_file"});
  document.erase("case");
  document["case_file"] = "none.json";
  EXPECT_EQ(test::pointers(as_file(document).faults), Pointers{"/case_file"});
  const auto broken = parse_study_file(
      document.dump(), [](const std::string&) { return std::optional<std::string>("{}"); });
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.faults.front().pointer, "/case_file");
  EXPECT_NE(test::text(broken.faults).find("none.json /ground: is missing"), std::string::npos)
      << test::text(broken.faults);
}

TEST(StudyFile, AllFaultsAreToldAtOnce) {
  json inputs = test::study_inputs();
  inputs["case"]["base_m"] = "low";
  inputs["cell_m"] = {0.5, -1, "1", 0.5};
  inputs["particles_per_cell"] = {4, 5};
  inputs["seeds"] = 51;
  inputs["reference"] = {{"runout_m", 0}};
  inputs["wanted_error"] = 2;
  inputs["machine"] = "";
  inputs["colour"] = "blue";
  EXPECT_EQ(faults_over_http(inputs),
            (Pointers{"/inputs/case/base_m", "/inputs/cell_m/1", "/inputs/cell_m/2",
                      "/inputs/cell_m/3", "/inputs/particles_per_cell/1", "/inputs/seeds",
                      "/inputs/reference/runout_m", "/inputs/reference/source",
                      "/inputs/wanted_error", "/inputs/machine", "/inputs/colour"}))
      << test::text(over_http(inputs).faults);
}

TEST(StudyFile, WhatIsMissingIsTold) {
  EXPECT_EQ(faults_over_http(json::object()),
            (Pointers{"/inputs/name", "/inputs/case", "/inputs/cell_m",
                      "/inputs/particles_per_cell", "/inputs/reference"}));
  EXPECT_EQ(test::pointers(parse_study_request("{}").faults), Pointers{"/inputs"});
  EXPECT_EQ(test::pointers(parse_study_request("[]").faults), Pointers{""});
  EXPECT_FALSE(parse_study_request("").faults.empty());
}

TEST(StudyFile, AResolutionTheCaseDoesNotAllowIsToldAtItsCellSize) {
  json inputs = test::study_inputs();
  inputs["cell_m"] = {1, 0.001, 50};
  EXPECT_EQ(faults_over_http(inputs), (Pointers{"/inputs/cell_m/1", "/inputs/cell_m/2"}));
}

TEST(StudyFile, ASettingTwiceAndTooManyRunsAreRefused) {
  json inputs = test::study_inputs();
  inputs["also"] = {{{"cell_m", 1}, {"particles_per_cell", 4}}};
  EXPECT_EQ(faults_over_http(inputs), Pointers{"/inputs/also/0/cell_m"});
  inputs.erase("also");
  inputs["cell_m"] = json::array();
  for (int i = 0; i < 20; ++i) inputs["cell_m"].push_back(0.5 + 0.01 * i);
  inputs["particles_per_cell"] = {1, 4, 9};
  inputs["seeds"] = 50;
  EXPECT_EQ(faults_over_http(inputs), Pointers{"/inputs"});
}

TEST(StudyFile, ReadersAndSchemaAgree) {
  const json sound = test::study_inputs();
  EXPECT_EQ(test::text(schema_faults(PublishedSchema::study_request, {{"inputs", sound}})), "");
  const json values[] = {nullptr, true, "text", -1, 2.5, json::array(), json::object(), {5}};
  for (const auto& member : sound.items()) {
    for (const json& value : values) {
      json inputs = sound;
      inputs[member.key()] = value;
      const auto faults = over_http(inputs).faults;
      if (schema_faults(PublishedSchema::study_request, {{"inputs", inputs}}).empty()) continue;
      EXPECT_FALSE(faults.empty()) << member.key() << " = " << value;
      EXPECT_EQ(test::text(faults).find("published schema"), std::string::npos)
          << member.key() << " = " << value << "\n"
          << test::text(faults);
    }
  }
}

TEST(StudyFile, ARunIsTheCaseAtItsResolution) {
  const StudyFile study = test::study_asked();
  const CaseFile run = case_of(study, {0.5, 9, 2});
  EXPECT_EQ(run.settings.resolution.cell_m, 0.5);
  EXPECT_EQ(run.settings.resolution.particles_per_cell, 9);
  EXPECT_EQ(run.settings.resolution.seed, 2U);
  EXPECT_EQ(run.settings.stop.max_time_s, 4);
  EXPECT_FALSE(run.settings.output.paraview);
  EXPECT_EQ(run_name({0.75, 4, 1}), "cell-0.75-particles-4-seed-1");
}

}  // namespace
}  // namespace leda::server
