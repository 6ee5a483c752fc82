#include "server/documents/result_document.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/server/documents/read_data.hpp"
#include "tests/server/documents/some_result.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using Pointers = std::multiset<std::string>;

TEST(ResultDocument, HasTheNamesOfTheContract) {
  const json out = to_document(test::some_result());
  EXPECT_EQ(out["status"], "at-rest");
  EXPECT_EQ(out["crest_to_crest_retrogression_m"], 103.2);
  EXPECT_EQ(out["crest_m"], (json{183, 21.7}));
  EXPECT_EQ(out["balances"]["energy"], 0.004);
  for (const char* key :
       {"runout_m", "runout_from_crest_m", "toe_m", "backscarp_m", "front_m", "trigger_used",
        "slides", "simulated_s", "run_time_s", "ns_per_particle_step", "steps", "particles",
        "numerical_dissipation", "warnings", "reason", "case_sha256", "version", "engine"}) {
    EXPECT_TRUE(out.contains(key)) << key;
  }
}

TEST(ResultDocument, ComesBackTheSame) {
  const SectionResult first = test::some_result();
  const auto parsed = parse_result(result_text(first));
  ASSERT_TRUE(parsed) << test::text(parsed.faults);
  EXPECT_EQ(to_document(*parsed.value), to_document(first));
  EXPECT_EQ(parsed.value->profile_after, first.profile_after);
  EXPECT_EQ(parsed.value->status, RunStatus::at_rest);
  EXPECT_EQ(parsed.value->steps, 24000);
}

TEST(ResultDocument, SaysWhatComputedIt) {
  SectionResult result = test::some_result();
  const json engine{{"precision", "single"},
                    {"instructions", "avx2"},
                    {"time_step_factor", 0.65},
                    {"averaged_dilation", false}};
  EXPECT_EQ(to_document(result)["engine"], engine);
  result.engine = {Precision::double_precision, "sse4", 0.5, true};
  EXPECT_EQ(parse_result(result_text(result)).value->engine, result.engine);
  result.engine.reset();  // Leda 0.1
  const auto old = parse_result(result_text(result));
  ASSERT_TRUE(old) << test::text(old.faults);
  EXPECT_FALSE(old.value->engine);
}

TEST(ResultDocument, NeverHoldsWhatIsNotFinite) {
  SectionResult broken = test::some_result();
  broken.runout_m = NAN;
  broken.balances.energy = INFINITY;
  broken.front.z = -double{INFINITY};
  broken.profile_after[1].z = NAN;
  const auto parsed = parse_result(result_text(broken));
  ASSERT_TRUE(parsed) << test::text(parsed.faults);
  EXPECT_EQ(parsed.value->status, RunStatus::unstable);
  EXPECT_EQ(parsed.value->runout_m, 0);
  EXPECT_TRUE(parsed.value->profile_after.empty());
  EXPECT_NE(parsed.value->reason.find("runout_m was nan"), std::string::npos);
  EXPECT_NE(parsed.value->reason.find("energy was inf"), std::string::npos);
}

TEST(ResultDocument, BrokenTextsDoNotEndTheRun) {
  SectionResult odd = test::some_result();
  odd.reason = "bytes \xff\xfe";
  EXPECT_TRUE(parse_result(result_text(odd)));
}

Pointers faults_after(const char* change) {
  const json document = to_document(test::some_result()).patch(json::parse(change));
  return test::pointers(parse_result(document.dump()).faults);
}

TEST(ResultDocument, CorruptOnesAreRefused) {
  EXPECT_EQ(faults_after(R"([{"op": "replace", "path": "/status", "value": "at_rest"},
                             {"op": "remove", "path": "/runout_m"},
                             {"op": "replace", "path": "/crest_m", "value": [1]},
                             {"op": "replace", "path": "/steps", "value": 1.5},
                             {"op": "replace", "path": "/balances", "value": {}},
                             {"op": "replace", "path": "/case_sha256", "value": "abc"},
                             {"op": "replace", "path": "/trigger_used", "value": "rain"},
                             {"op": "add", "path": "/more", "value": 1}])"),
            (Pointers{"/status", "/runout_m", "/crest_m", "/steps", "/balances/mass",
                      "/balances/momentum", "/balances/energy", "/case_sha256", "/trigger_used",
                      "/more"}));
  EXPECT_EQ(faults_after(R"([{"op": "replace", "path": "/crest_to_crest_retrogression_m",
                              "value": -1},
                             {"op": "replace", "path": "/profile_after_m",
                              "value": [[1, 0], [0, 0]]},
                             {"op": "replace", "path": "/warnings", "value": [1]}])"),
            (Pointers{"/crest_to_crest_retrogression_m", "/profile_after_m/1", "/warnings/0"}));
  EXPECT_EQ(faults_after(R"([{"op": "replace", "path": "/engine",
                              "value": {"precision": "half", "averaged_dilation": 1, "x": 1}}])"),
            (Pointers{"/engine/precision", "/engine/instructions", "/engine/time_step_factor",
                      "/engine/averaged_dilation", "/engine/x"}));
  EXPECT_FALSE(parse_result(""));
  const std::string whole = result_text(test::some_result());
  EXPECT_FALSE(parse_result(whole.substr(0, whole.size() / 2)));
}

TEST(ProfileCsv, HasAHeaderAndShortNumbers) {
  EXPECT_EQ(profile_csv({{0, 21.7}, {0.1, -3}}), "x_m,z_m\n0,21.7\n0.1,-3\n");
}

}  // namespace
}  // namespace leda::server
