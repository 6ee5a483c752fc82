#pragma once
// The study that tests start from: the small bank at two cell sizes, each with two seeds.

#include <nlohmann/json.hpp>

#include "server/documents/study_document.hpp"
#include "tests/server/documents/read_data.hpp"
#include "tests/server/documents/some_result.hpp"

namespace leda::test {

inline nlohmann::json study_inputs() {
  return {{"name", "bank"},
          {"case", nlohmann::json::parse(read_case("small-bank.json"))},
          {"cell_m", {0.5, 1}},
          {"particles_per_cell", {4}},
          {"seeds", 1},
          {"reference", {{"retrogression_m", 10}, {"runout_m", 5}, {"source", "field <1994>"}}},
          {"wanted_error", 0.1},
          {"machine", "a machine"}};
}

inline server::StudyFile study_asked(const nlohmann::json& inputs = study_inputs()) {
  return server::parse_study_request(nlohmann::json{{"inputs", inputs}}.dump()).value.value();
}

inline solver::StudyRun study_run(solver::StudySetting setting, std::uint64_t seed,
                                  double retrogression_m, double runout_m, double run_time_s) {
  SectionResult result = some_result();
  result.crest_to_crest_retrogression_m = retrogression_m;
  result.runout_m = runout_m;
  result.run_time_s = run_time_s;
  return {setting, seed, result, ""};
}

/// At 1 m 2 s and errors of 20 %, at 0.5 m 16 s and errors of 1 and 3 %: 2 % in the mean.
inline server::Study some_study() {
  return server::conclude(
      study_asked(),
      {study_run({1, 4}, 0, 12, 5, 2), study_run({1, 4}, 1, 12, 5.5, 2.2),
       study_run({0.5, 4}, 0, 10.1, 5, 16), study_run({0.5, 4}, 1, 10.3, 4.9, 17)},
      "2026-01-31T12:00:00.000Z");
}

/// At 1 m too, with the case's own step and one of 0.9, which retrogresses 0.6 m less.
inline server::Study study_of_steps() {
  nlohmann::json inputs = study_inputs();
  inputs["cell_m"] = {1};
  inputs["time_step_factor"] = {0.65, 0.9};
  return server::conclude(
      study_asked(inputs),
      {study_run({1, 4, 0.9}, 0, 11.4, 5, 1.5), study_run({1, 4, 0.9}, 1, 11.4, 5, 1.6),
       study_run({1, 4, 0.65}, 0, 12, 5, 2), study_run({1, 4, 0.65}, 1, 12, 5.5, 2.2)},
      "2026-01-31T12:00:00.000Z");
}

}  // namespace leda::test
