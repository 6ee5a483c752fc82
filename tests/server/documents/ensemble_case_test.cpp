#include "server/documents/ensemble_case.hpp"

#include <gtest/gtest.h>

#include <set>

#include "server/documents/ensemble_document.hpp"
#include "server/documents/json_syntax.hpp"
#include "server/documents/published_schema.hpp"
#include "server/drawings/ensemble_drawing.hpp"
#include "tests/server/documents/read_data.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using Pointers = std::multiset<std::string>;

json input(const char* name, const char* path, const char* apply, json distribution) {
  return {
      {"name", name}, {"path", path}, {"apply", apply}, {"distribution", std::move(distribution)}};
}

json ensemble() {
  return {{"inputs",
           {input("su", "/materials/*/peak_strength_kPa", "scale",
                  {{"type", "lognormal"}, {"mean", 1}, {"cov", 0.15}}),
            input("water", "/water_table/depth_m", "set",
                  {{"type", "triangular"}, {"min", 0}, {"mode", 1}, {"max", 3}})}},
          {"stop", {{"min_members", 64}, {"max_members", 128}}}};
}

json bank(const json& of = ensemble()) {
  json document = json::parse(test::read_case("sainte-monique-AA.json"));
  document["ensemble"] = of;
  return document;
}

Parsed<EnsembleCase> parsed(const json& document) { return parse_ensemble_case(document.dump()); }

Pointers faults(const json& of) { return test::pointers(parsed(bank(of)).faults); }

std::string text(const json& of) { return test::text(parsed(bank(of)).faults); }

TEST(EnsembleCase, MembersAreCasesOfTheirOwnThatDifferInTheirInputsAndSeeds) {
  const auto read = parsed(bank());
  ASSERT_TRUE(read) << test::text(read.faults);
  const json member = read.value->case_of({7});
  const auto inputs = read.value->inputs_of(7);
  EXPECT_TRUE(read_case_file(member));
  EXPECT_EQ(member["name"], "sainte-monique-AA member-7");
  EXPECT_EQ(member["materials"]["S1"]["peak_strength_kPa"], 40.5 * inputs[0]);
  EXPECT_EQ(member["materials"]["crust"]["peak_strength_kPa"], 90 * inputs[0]);
  EXPECT_EQ(member["water_table"]["depth_m"], inputs[1]);
  EXPECT_NE(member["resolution"]["seed"], 0);
  EXPECT_FALSE(member.contains("ensemble"));
  json given = member;
  for (const char* name : {"S1", "B1", "crust"}) {
    given["materials"][name]["peak_strength_kPa"] = bank()["materials"][name]["peak_strength_kPa"];
  }
  given["water_table"] = bank()["water_table"];
  given["resolution"].erase("seed");
  given["name"] = bank()["name"];
  json without = bank();
  without.erase("ensemble");
  EXPECT_EQ(given, without) << "a member changes what no input names";
  EXPECT_EQ(case_sha256(*read_case_file(member).value),
            case_sha256(*parse_case_file(parsed(bank()).value->case_of({7}).dump()).value));
}

TEST(EnsembleCase, AFieldMayBeUncertainAndEachMemberHasItsOwnSeed) {
  json of = ensemble();
  of["inputs"].push_back(input("variation", "/materials/S1/field/cov", "set",
                               {{"type", "uniform"}, {"min", 0.1}, {"max", 0.4}}));
  json document = bank(of);
  document["materials"]["S1"]["field"] = {{"cov", 0.2}, {"horizontal_m", 20}, {"vertical_m", 2}};
  const auto read = parsed(document);
  ASSERT_TRUE(read) << test::text(read.faults);
  const json one = read.value->case_of({0}), other = read.value->case_of({1});
  EXPECT_EQ(one["materials"]["S1"]["field"]["cov"], read.value->inputs_of(0)[2]);
  EXPECT_NE(one["materials"]["S1"]["field"]["cov"], other["materials"]["S1"]["field"]["cov"]);
  EXPECT_NE(one["resolution"]["seed"], other["resolution"]["seed"]);
  EXPECT_EQ(one["materials"]["S1"]["field"]["horizontal_m"], 20);

  of["inputs"][2]["distribution"]["max"] = 1.5;
  document["ensemble"] = of;
  EXPECT_EQ(test::pointers(parsed(document).faults), Pointers{"/ensemble/inputs/2/distribution"});
}

TEST(EnsembleCase, TheCheckHasOtherSeedsAndFinerCells) {
  json of = ensemble();
  of["check"] = {{"cell_m", 0.25}, {"members", 2}, {"seeds", 3}};
  const auto read = parsed(bank(of));
  ASSERT_TRUE(read) << test::text(read.faults);
  const auto runs = member_runs(read.value->asked.plan, 0, 4);
  std::vector<std::string> names;
  for (const MemberRun& run : runs) names.push_back(run_name(run));
  EXPECT_EQ(names,
            (std::vector<std::string>{
                "member-0", "member-0-seed-1", "member-0-seed-2", "member-0-finer", "member-1",
                "member-1-seed-1", "member-1-seed-2", "member-1-finer", "member-2", "member-3"}));
  const json own = read.value->case_of(runs[0]), seed = read.value->case_of(runs[1]),
             finer = read.value->case_of(runs[3]);
  EXPECT_EQ(own["materials"], seed["materials"]);
  EXPECT_NE(own["resolution"]["seed"], seed["resolution"]["seed"]);
  EXPECT_EQ(own["resolution"]["seed"], finer["resolution"]["seed"]);
  EXPECT_EQ(finer["resolution"]["cell_m"], 0.25);
}

TEST(EnsembleCase, PathsGoThroughListsAndAddAndSetBeforeScale) {
  json of = ensemble();
  of["inputs"] = {
      input("factor", "/ground/*/1", "scale",
            {{"type", "discrete"}, {"values", {2}}, {"weights", {1}}}),
      input("shift", "/ground/0/1", "add",
            {{"type", "discrete"}, {"values", {0.5}}, {"weights", {1}}}),
      input("base", "/base_m", "set", {{"type", "discrete"}, {"values", {1}}, {"weights", {1}}})};
  const auto read = parsed(bank(of));
  ASSERT_TRUE(read) << test::text(read.faults);
  const json member = read.value->case_of({0});
  EXPECT_EQ(member["ground"][0], json({0, 2 * 21.7 + 0.5}));
  EXPECT_EQ(member["ground"][5], json({306, 2 * 17.0}));
  EXPECT_EQ(member["base_m"], 1);
}

TEST(EnsembleCase, EveryFaultHasItsPointer) {
  json of = ensemble();
  of["inputs"][0]["path"] = "/materials/S9/peak_strength_kPa";
  of["inputs"][1]["path"] = "/layers/0/material";
  of["inputs"].push_back(input("none", "/materials/S1/softening/rate/*", "set",
                               {{"type", "uniform"}, {"min", 0}, {"max", 1}}));
  of["inputs"].push_back(
      input("list", "/ground", "set",
            {{"type", "discrete"}, {"values", {1, 2}}, {"weights", {0.5, 0.6}}}));
  of["stop"]["max_members"] = 1'000'000;
  of["sampling"] = {{"method", "halton"}, {"seed", -1}};
  of["exceedance"] = {0.5, 0.2};
  of["raster"] = {{"cell_m", 2}};
  of["typo"] = 1;
  EXPECT_EQ(faults(of),
            (Pointers{"/ensemble/inputs/0/path", "/ensemble/inputs/1/path",
                      "/ensemble/inputs/2/path", "/ensemble/inputs/3/path",
                      "/ensemble/inputs/3/distribution/weights", "/ensemble/stop/max_members",
                      "/ensemble/sampling/method", "/ensemble/sampling/seed",
                      "/ensemble/exceedance/1", "/ensemble/raster", "/ensemble/typo"}))
      << text(of);
  EXPECT_NE(text(of).find("there is no S9 in /materials, which has B1, S1, crust"),
            std::string::npos)
      << text(of);
}

TEST(EnsembleCase, AStarThatMatchesNothingSaysSo) {
  json of = ensemble();
  of["inputs"][0]["path"] = "/base_m/*";
  EXPECT_EQ(faults(of), Pointers{"/ensemble/inputs/0/path"});
  EXPECT_NE(text(of).find("* matches nothing in /base_m"), std::string::npos) << text(of);
}

TEST(EnsembleCase, CorrelationsThatAreNoneAreRefused) {
  json of = ensemble();
  of["inputs"].push_back(
      input("base", "/base_m", "add", {{"type", "uniform"}, {"min", 0}, {"max", 0.1}}));
  const auto rho = [](const char* a, const char* b, double value) {
    return json{{"between", {a, b}}, {"rho", value}};
  };
  of["rank_correlations"] = {rho("su", "water", 0.9), rho("water", "base", 0.9),
                             rho("su", "base", -0.9)};
  EXPECT_EQ(faults(of), Pointers{"/ensemble/rank_correlations"});
  of["rank_correlations"] = {rho("su", "snow", 0.5), rho("su", "su", 0.5), rho("su", "water", 1)};
  EXPECT_EQ(faults(of), (Pointers{"/ensemble/rank_correlations/0/between/1",
                                  "/ensemble/rank_correlations/1/between",
                                  "/ensemble/rank_correlations/2/rho"}));
}

TEST(EnsembleCase, ADrawOutsideValidityIsToldBeforeAnyRun) {
  json of = ensemble();
  of["inputs"][0]["apply"] = "set";
  of["inputs"][0]["path"] = "/materials/S1/peak_strength_kPa";
  of["inputs"][0]["distribution"] = {{"type", "normal"}, {"mean", 20}, {"sd", 12}};
  EXPECT_TRUE(faults(of).contains("/ensemble/inputs/0/distribution")) << text(of);
  EXPECT_NE(text(of).find("draws "), std::string::npos) << text(of);
  EXPECT_NE(text(of).find("more like it"), std::string::npos) << text(of);
}

TEST(EnsembleCase, NumbersOfMembersMakeWholeNets) {
  json of = ensemble();
  of["stop"] = {{"min_members", 60}, {"max_members", 500}};
  EXPECT_EQ(faults(of), (Pointers{"/ensemble/stop/min_members", "/ensemble/stop/max_members"}));
  of["stop"] = {{"min_members", 100}, {"max_members", 200}};
  of["sampling"] = {{"method", "random"}};
  EXPECT_TRUE(parsed(bank(of))) << text(of);
  of["sampling"]["replicates"] = 8;
  EXPECT_EQ(faults(of), Pointers{"/ensemble/sampling/replicates"});
}

TEST(EnsembleCase, TwoInputsCannotSetOneNumber) {
  json of = ensemble();
  of["inputs"].push_back(of["inputs"][1]);
  of["inputs"][2]["name"] = "again";
  EXPECT_EQ(faults(of), Pointers{"/ensemble/inputs/2/path"});
}

TEST(EnsembleCase, FaultsOfTheCaseAreTold) {
  json document = bank();
  document["base_m"] = "low";
  EXPECT_EQ(test::pointers(parsed(document).faults), Pointers{"/base_m"});
  document.erase("ensemble");
  EXPECT_EQ(test::pointers(parsed(document).faults), Pointers{"/ensemble"});
}

TEST(EnsembleCase, EveryDistributionIsReadAsThePublishedSchemaHasIt) {
  for (const char* good : {R"({"type": "normal", "mean": 1, "sd": 0.1, "min": 0.8})",
                           R"({"type": "lognormal", "mean": 1, "cov": 0.1})",
                           R"({"type": "lognormal", "median": 1, "sd_ln": 0.1})",
                           R"({"type": "uniform", "min": 0.9, "max": 1})",
                           R"({"type": "triangular", "min": 0.9, "mode": 0.9, "max": 1})",
                           R"({"type": "pert", "min": 0.9, "mode": 1, "max": 1.1})",
                           R"({"type": "discrete", "values": [1, 2], "weights": [0.5, 0.5]})",
                           R"({"type": "sample", "set": "s", "values": [1], "weights": [1]})"}) {
    json of = ensemble();
    of["inputs"][0]["distribution"] = json::parse(good);
    EXPECT_TRUE(parsed(bank(of))) << good << text(of);
    EXPECT_TRUE(schema_faults(PublishedSchema::ensemble, of).empty()) << good;
  }
  for (const char* bad :
       {R"({"type": "normal", "mean": 1})", R"({"type": "lognormal", "mean": 1, "sd_ln": 0.1})",
        R"({"type": "lognormal", "mean": 1, "cov": 0.1, "median": 1})",
        R"({"type": "uniform", "min": 0.9, "max": 1, "mode": 1})", R"({"type": "cauchy"})",
        R"({"mean": 1})", R"("normal")"}) {
    json of = ensemble();
    of["inputs"][0]["distribution"] = json::parse(bad);
    EXPECT_FALSE(parsed(bank(of))) << bad;
    EXPECT_FALSE(schema_faults(PublishedSchema::ensemble, of).empty()) << bad;
  }
}

/// 64 members of a bank whose distances follow their strength; one unstable, one censored.
std::vector<MemberRow> rows_of(const EnsembleCase& of) {
  std::vector<MemberRow> rows;
  for (std::size_t m = 0; m < 64; ++m) {
    MemberRow row{of.of.section.name, {m}, 1 / 64.0, of.inputs_of(m), m, 1, SectionResult{}};
    row.result->status = m == 0 ? RunStatus::unstable : RunStatus::at_rest;
    row.result->crest_to_crest_retrogression_m = 200 - 100 * row.inputs[0];
    row.result->runout_m = 20 + double(m) / 8;
    if (m == 1) row.result->retrogression_is = Bound::lower_bound;
    rows.push_back(std::move(row));
  }
  return rows;
}

TEST(EnsembleDocument, SaysTheSectionsNumbersAndItsCondition) {
  const auto of = parsed(bank()).value.value();
  const auto rows = rows_of(of);
  const SectionEnsemble ensemble{"AA'", of.asked, summarize(of.asked.plan, members_of(rows))};
  const json document = to_document(ensemble);
  EXPECT_EQ(document["members"], 64);
  EXPECT_EQ(document["by_status"], json({{"at-rest", 63}, {"unstable", 1}}));
  EXPECT_NE(document["condition"].get<std::string>().find("no yearly probability"),
            std::string::npos);
  EXPECT_GT(document["retrogression"]["indices"]["su"]["first_order"], 0.8);
  EXPECT_LT(document["retrogression"]["indices"]["water"]["first_order"], 0.2);
  EXPECT_EQ(document["retrogression"]["quantiles"].size(), 5U);
  EXPECT_EQ(document["runout"]["chance"], nullptr);
  EXPECT_EQ(document["inputs"][0]["path"], "/materials/*/peak_strength_kPa");
  const std::string svg = ensemble_svg({ensemble});
  EXPECT_TRUE(svg.starts_with("<svg"));
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_NE(svg.find("no yearly probability"), std::string::npos);
  EXPECT_NE(ensemble_table(ensemble).find("64 members"), std::string::npos);
}

TEST(EnsembleDocument, MembersAreALineEach) {
  const auto of = parsed(bank()).value.value();
  auto rows = rows_of(of);
  rows[2].result.reset();
  const std::string head = members_csv_head(of.asked.plan.inputs);
  const auto commas = std::ranges::count(head, ',');
  EXPECT_EQ(head.find("section,member,kind,weight,su,water,seed"), 0U);
  for (const MemberRow& row : rows) {
    const std::string line = members_csv_line(row);
    EXPECT_EQ(std::ranges::count(line, ','), commas) << line;
  }
  EXPECT_NE(members_csv_line(rows[2]).find("no-result"), std::string::npos);
  EXPECT_NE(members_csv_line(rows[1]).find("lower-bound"), std::string::npos);
}

}  // namespace
}  // namespace leda::server
