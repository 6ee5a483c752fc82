#include "server/documents/study_file.hpp"

#include <gtest/gtest.h>

#include "server/documents/published_schema.hpp"
#include "server/documents/study_setting.hpp"
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
  const std::vector<solver::RepeatedSetting> expected{
      {{0.5, 1}, 1}, {{0.5, 9}, 1}, {{1, 1}, 1}, {{1, 9}, 1}, {{0.4, 4}, 0}};
  EXPECT_EQ(parsed.value->question.settings, expected);
  EXPECT_EQ(parsed.value->question.reference->source, "field <1994>");
  EXPECT_EQ(parsed.value->machine, "a machine");
}

TEST(StudyFile, TimeStepsAreAnAxisOfTheGridAndTheCasesOwnWhereAbsent) {
  json inputs = test::study_inputs();
  inputs["case"]["time_step_factor"] = 0.5;
  inputs["cell_m"] = {1};
  inputs["particles_per_cell"] = {4, 9};
  inputs["also"] = {{{"cell_m", 2}, {"particles_per_cell", 4}},
                    {{"cell_m", 2}, {"particles_per_cell", 4}, {"time_step_factor", 1}}};
  using Settings = std::vector<solver::RepeatedSetting>;
  EXPECT_EQ(test::study_asked(inputs).question.settings,
            (Settings{{{1, 4, 0.5}, 1}, {{1, 9, 0.5}, 1}, {{2, 4, 0.5}, 1}, {{2, 4, 1}, 1}}));
  inputs["time_step_factor"] = {0.4, 0.9};
  const StudyFile study = test::study_asked(inputs);
  EXPECT_EQ(study.question.settings, (Settings{{{1, 4, 0.4}, 1},
                                               {{1, 4, 0.9}, 1},
                                               {{1, 9, 0.4}, 1},
                                               {{1, 9, 0.9}, 1},
                                               {{2, 4, 0.5}, 1},
                                               {{2, 4, 1}, 1}}));
  EXPECT_TRUE(tells_time_step(study));
  inputs["time_step_factor"] = {0.5};
  inputs.erase("also");
  EXPECT_FALSE(tells_time_step(test::study_asked(inputs)));
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

TEST(StudyFile, BadTimeStepsAreToldWhereTheyStand) {
  json inputs = test::study_inputs();
  inputs["time_step_factor"] = {0, 0.65, 1.01, 1, "long", 0.65, -0.5};
  inputs["also"] = {{{"cell_m", 2}, {"particles_per_cell", 4}, {"time_step_factor", 1.5}},
                    {{"cell_m", 2}, {"particles_per_cell", 4}, {"time_step_factor", nullptr}}};
  const auto faults = over_http(inputs).faults;
  EXPECT_EQ(test::pointers(faults),
            (Pointers{"/inputs/time_step_factor/0", "/inputs/time_step_factor/2",
                      "/inputs/time_step_factor/4", "/inputs/time_step_factor/5",
                      "/inputs/time_step_factor/6", "/inputs/also/0/time_step_factor",
                      "/inputs/also/1/time_step_factor"}))
      << test::text(faults);
  EXPECT_NE(test::text(faults).find("is 1.01, must be greater than 0 and at most 1"),
            std::string::npos);
  for (const json& list : {json(0.9), json::array(), json(std::vector<double>(21, 0.5))}) {
    inputs = test::study_inputs();
    inputs["time_step_factor"] = list;
    EXPECT_EQ(faults_over_http(inputs), Pointers{"/inputs/time_step_factor"}) << list;
  }
}

TEST(StudyFile, LongStepsWithOneParticleACellAreRefusedWhereTheyAreAskedFor) {
  json inputs = test::study_inputs();
  inputs["particles_per_cell"] = {1, 4};
  inputs["time_step_factor"] = {0.65, 0.9};
  inputs["also"] = {{{"cell_m", 2}, {"particles_per_cell", 1}, {"time_step_factor", 1}},
                    {{"cell_m", 2}, {"particles_per_cell", 4}, {"time_step_factor", 1}}};
  const Pointers wrong{"/inputs/time_step_factor/1", "/inputs/also/0/time_step_factor"};
  EXPECT_EQ(faults_over_http(inputs), wrong) << test::text(over_http(inputs).faults);
  EXPECT_NE(test::text(over_http(inputs).faults).find("(cell 0.5 m, 1 particle, step 0.9)"),
            std::string::npos);
  // A fault of the case hides none of these.
  Pointers with_case = wrong;
  with_case.insert("/inputs/case/base_m");
  inputs["case"]["base_m"] = "low";
  EXPECT_EQ(faults_over_http(inputs), with_case) << test::text(over_http(inputs).faults);
  // The case's own is the case's fault.
  inputs = test::study_inputs();
  inputs["case"]["time_step_factor"] = 0.9;
  inputs["particles_per_cell"] = {1};
  EXPECT_EQ(faults_over_http(inputs), Pointers{"/inputs/case/time_step_factor"});
}

TEST(StudyFile, TheCasesOwnTimeStepAskedForAgainIsASettingTwice) {
  json inputs = test::study_inputs();
  inputs["time_step_factor"] = {0.65, 0.9};
  inputs["also"] = {{{"cell_m", 1}, {"particles_per_cell", 4}},
                    {{"cell_m", 1}, {"particles_per_cell", 4}, {"time_step_factor", 0.9}},
                    {{"cell_m", 1}, {"particles_per_cell", 4}, {"time_step_factor", 0.8}}};
  const auto faults = over_http(inputs).faults;
  EXPECT_EQ(test::pointers(faults), (Pointers{"/inputs/also/0/cell_m", "/inputs/also/1/cell_m"}));
  EXPECT_NE(test::text(faults).find("1 m, 4 particles, step 0.9 is asked for twice"),
            std::string::npos)
      << test::text(faults);
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
  json sound = test::study_inputs();
  sound["time_step_factor"] = {0.65, 0.9};
  sound["also"] = {{{"cell_m", 2}, {"particles_per_cell", 4}, {"time_step_factor", 1}}};
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

TEST(StudyFile, ARunIsTheCaseAtItsSetting) {
  const CaseFile of = test::study_asked().of;
  const CaseFile run = case_of(of, {{0.5, 9, 0.9}, 2, {}, ""});
  EXPECT_EQ(run.settings.resolution.cell_m, 0.5);
  EXPECT_EQ(run.settings.resolution.particles_per_cell, 9);
  EXPECT_EQ(run.settings.resolution.seed, 2U);
  EXPECT_EQ(run.settings.time_step_factor, 0.9);
  EXPECT_EQ(run.settings.stop.max_time_s, 4);
  EXPECT_FALSE(run.settings.output.paraview);
}

TEST(StudyFile, ARunIsNamedByItsTimeStepWhereThatIsNotTheCasesOwn) {
  CaseFile of = test::study_asked().of;
  EXPECT_EQ(run_name(of, {{0.75, 4, 0.65}, 1, {}, ""}), "cell-0.75-particles-4-seed-1");
  EXPECT_EQ(run_name(of, {{0.75, 4, 0.9}, 1, {}, ""}), "cell-0.75-particles-4-step-0.9-seed-1");
  of.settings.time_step_factor = 0.9;
  EXPECT_EQ(run_name(of, {{0.75, 4, 0.9}, 1, {}, ""}), "cell-0.75-particles-4-seed-1");
}

}  // namespace
}  // namespace leda::server
