
#include <gtest/gtest.h>

#include <algorithm>

#include "server/documents/simulate_request.hpp"
#include "server/jobs/dry_run.hpp"
#include "server/jobs/process.hpp"
#include "server/layers/job_ensemble.hpp"
#include "server/operate/problem.hpp"
#include "tests/server/run_fixture.hpp"
#include "tests/server/temporary_folder.hpp"

namespace leda::server {
namespace {

using db::SectionState;
using nlohmann::json;

std::string request() {
  json document = json::parse(tests::simulate_request());
  document["inputs"]["ensemble"] = json::parse(R"({
    "inputs": [{"name": "su", "path": "/materials/*/peak_strength_kPa", "apply": "scale",
                "distribution": {"type": "uniform", "min": 0.8, "max": 1.2}}],
    "sampling": {"replicates": 4},
    "stop": {"min_members": 16, "max_members": 64, "half_width": 0.3}})");
  return document.dump();
}

/// A job of the store with its members laid out.
class EnsembleJob : public testing::Test {
 protected:
  EnsembleJob() {
    job.id = "job";
    job.process = "simulate-section";
    job.request = request();
    store.add_job(job);
    work = find_process(job.process)->open(job.request, {data, store});
    store.set_sections(job.id, work->plan());
  }

  /// Members of a look end, each with the distance that `distance` gives its number.
  template <class Distance>
  void end(std::size_t from, std::size_t before, const Distance& distance) {
    const auto sections = members();
    for (std::size_t i = from; i < before; ++i) {
      const std::string run = "run-" + std::to_string(i);
      store.start_run(sections.at(i).id, run);
      SectionResult result;
      result.crest_to_crest_retrogression_m = distance(i);
      result.status = distance(i) > 0 ? RunStatus::at_rest : RunStatus::stable;
      store.take_in(sections.at(i).id, run, result, work->place(sections.at(i), result), "{}");
    }
  }

  std::string not_needed(std::size_t member) const {
    return work->not_needed(members().at(member));
  }

  std::vector<db::SectionRecord> members() const { return store.members(job.id, 0); }

  EnsembleOfSection ensemble() const {
    return ensemble_or_problem(store, job).of_section(store.sections(job.id).at(0));
  }

  tests::TemporaryFolder folder;
  DataFolder data{folder.path()};
  db::Store store{data.store()};
  db::JobRecord job;
  std::unique_ptr<Work> work;
};

TEST_F(EnsembleJob, HasASectionAsGivenAndMembersWhoseCasesAreTheirOwn) {
  const auto sections = store.sections(job.id);
  ASSERT_EQ(sections.size(), 1U);
  const auto rows = members();
  ASSERT_EQ(rows.size(), 64U);
  EXPECT_EQ(rows[3].name, sections[0].name + " member-3");
  EXPECT_EQ(rows[3].ground.size(), 0U) << "a list of members is without it";
  EXPECT_EQ(store.section(rows[3].id)->ground.size(), sections[0].ground.size());
  const auto given = parse_case_file(work->case_file(sections[0]));
  const auto first = parse_case_file(work->case_file(rows[0]));
  const auto other = parse_case_file(work->case_file(rows[1]));
  ASSERT_TRUE(given && first && other);
  EXPECT_NE(case_sha256(*first.value), case_sha256(*other.value));
  EXPECT_NE(case_sha256(*first.value), case_sha256(*given.value));
}

TEST_F(EnsembleJob, RunsNoMoreThanItNeeds) {
  EXPECT_EQ(not_needed(16), "") << "the first look is not over";
  end(0, 16, [](std::size_t) { return 10; });
  EXPECT_EQ(not_needed(15), "");
  EXPECT_NE(not_needed(16).find("16 members"), std::string::npos);
}

TEST_F(EnsembleJob, GoesOnWhileItIsNotSure) {
  end(0, 16, [](std::size_t i) { return i % 2 == 0 ? 0 : 50; });
  EXPECT_EQ(not_needed(16), "");
  const auto by_now = ensemble();
  ASSERT_TRUE(by_now.ensemble);
  EXPECT_EQ(by_now.ensemble->summary.members, 16U);
  EXPECT_EQ(by_now.ensemble->summary.ending, solver::Ending::more_members);
}

TEST_F(EnsembleJob, WhatAnotherServerTakesUpIsJudgedByTheLookThatEndedIt) {
  end(0, 17, [](std::size_t) { return 10; });  // a free core had begun one more
  const auto rows = members();
  for (std::size_t i = 17; i < 40; ++i) {
    store.set_section_state(rows[i].id, SectionState::left_out, "not needed");
  }
  const auto taken_up = find_process(job.process)->open(job.request, {data, store});
  EXPECT_NE(taken_up->not_needed(rows.at(40)).find("16 members"), std::string::npos);
  const auto of_section = ensemble();
  EXPECT_EQ(of_section.ensemble->summary.members, 16U);
  ASSERT_EQ(of_section.rows.size(), 17U);
  EXPECT_EQ(of_section.rows[15].weight, 1 / 16.0);
  EXPECT_EQ(of_section.rows[16].weight, 0);
}

TEST_F(EnsembleJob, SaysNothingBeforeItsFirstLook) {
  end(0, 15, [](std::size_t) { return 10; });
  EXPECT_FALSE(ensemble().ensemble);
  db::JobRecord plain = job;
  plain.id = "plain";
  plain.request = tests::simulate_request();
  store.add_job(plain);
  EXPECT_THROW(ensemble_or_problem(store, plain), Problem);
}

TEST_F(EnsembleJob, AFailedMemberIsCountedBothWays) {
  end(1, 16, [](std::size_t) { return 10; });
  store.set_section_state(members().at(0).id, SectionState::failed, "it crashed");
  const auto of_section = ensemble();
  EXPECT_EQ(of_section.ensemble->summary.by_status.at("no-result"), 1U);
  EXPECT_LT(of_section.ensemble->summary.probability_of_sliding, 1);
}

TEST_F(EnsembleJob, ADryRunTellsTheLeastAndTheMost) {
  const json dry = dry_run(*find_process(job.process), *work, work->plan(), store);
  EXPECT_EQ(dry["sections"].size(), 1U);
  const json& estimate = dry["estimate"];
  EXPECT_EQ(estimate["runs"], 1 + 64);
  EXPECT_NEAR(estimate["core_hours"].get<double>() / (1 + 64),
              estimate["core_hours_at_least"].get<double>() / (1 + 16), 1e-9);
}

TEST(SimulateRequest, FaultsOfTheEnsembleHaveTheirPointers) {
  json document = json::parse(request());
  document["inputs"]["ensemble"]["inputs"][0]["path"] = "/materials/sand/peak_strength_kPa";
  document["inputs"]["ensemble"]["stop"]["max_members"] = 1'000'000;
  const auto faults = parse_simulate_request(document.dump()).faults;
  ASSERT_EQ(faults.size(), 2U);
  EXPECT_EQ(faults[0].pointer, "/inputs/ensemble/stop/max_members");
  EXPECT_EQ(faults[1].pointer, "/inputs/ensemble/inputs/0/path");
}

}  // namespace
}  // namespace leda::server
