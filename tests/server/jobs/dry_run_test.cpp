#include "server/jobs/dry_run.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "server/documents/execute_options.hpp"
#include "server/jobs/run_size.hpp"
#include "tests/server/run_fixture.hpp"
#include "tests/server/temporary_folder.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

Section block() {
  Section section;
  section.ground = {{0, 10}, {100, 10}};
  section.base_m = 0;
  Layer layer;
  layer.material = "clay";
  section.layers = {layer};
  Material clay;
  clay.unit_weight = 9810 * 2;
  clay.shear_modulus_Pa = 2e6;
  clay.poisson_ratio = 0.25;  // M = 3 G
  section.materials["clay"] = clay;
  return section;
}

TEST(RunSize, CountsParticlesAndSteps) {
  RunSettings settings;
  settings.resolution = {0.5, 4, 0};
  settings.time_step_factor = 0.5;
  settings.stop.max_time_s = 60;
  settings.output.frame_interval_s = 10;
  const RunSize size = run_size(block(), settings);
  EXPECT_DOUBLE_EQ(size.particles, 1000 / 0.25 * 4);
  EXPECT_NEAR(size.steps_per_simulated_s, std::sqrt(6e6 / 2000) / 0.25, 1e-9);
  EXPECT_DOUBLE_EQ(size.frames, 8);
}

TEST(RunSize, CountsTheStepsThatARunMayTake) {
  RunSettings settings;
  settings.resolution = {0.5, 4, 0};
  settings.time_step_factor = 0.95;
  const double waves_per_s = std::sqrt(6e6 / 2000) / 0.5;
  EXPECT_NEAR(run_size(block(), settings).steps_per_simulated_s, waves_per_s / 0.95, 1e-9);
  Section flows = block();
  flows.materials["clay"].flow = FlowLaw{};
  EXPECT_NEAR(run_size(flows, settings).steps_per_simulated_s, waves_per_s / 0.95, 1e-9);
}

TEST(RunSize, CostGrowsWithWhatRunsTook) {
  const RunSize size{1e6, 100, 120, 2, 12};
  const RunCost cost = cost_of(size, {5, 30, 40, 0});
  EXPECT_NEAR(cost.likely_core_s, 1e6 * 100 * 40e-9 * 30, 1e-6);
  EXPECT_NEAR(cost.longest_core_s, 4 * cost.likely_core_s, 1e-6);
  EXPECT_GT(cost.disk_bytes, 1e8);
  EXPECT_EQ(typical_or_default(std::nullopt).runs, 0);
  EXPECT_GT(cost_of({1e6, 100, 120, 2, 12}, typical_or_default(std::nullopt)).likely_core_s, 0);
}

TEST(DryRun, TellsSectionsAndCostAndChangesNothing) {
  const tests::TemporaryFolder folder;
  const DataFolder data(folder.path());
  const db::Store store(data.store());
  const Process& process = *find_process("simulate-section");
  const auto work = process.open(tests::simulate_request(), {data, store});
  const json document = dry_run(process, *work, work->plan(), store);
  EXPECT_EQ(document["processID"], "simulate-section");
  ASSERT_EQ(document["sections"].size(), 1U);
  const json& estimate = document["estimate"];
  EXPECT_EQ(estimate["runs"], 1);
  EXPECT_GT(estimate["core_hours"], 0.0);
  EXPECT_GE(estimate["core_hours_at_most"], estimate["core_hours"]);
  EXPECT_GT(estimate["disk_bytes"], 1e4);
  // 640 m2 above the base on cells of 2 m with 4 particles.
  EXPECT_NEAR(document["sections"][0]["particles"].get<double>(), 580, 1);
  EXPECT_EQ(store.count_jobs({}), 0);
}

std::vector<std::string> faults_of(const std::string& text) {
  const json document = json::parse(text);
  FaultList faults;
  ObjectReader body(document, "", faults);
  read_execute_options(body, faults);
  std::vector<std::string> pointers;
  for (const auto& fault : faults.take()) pointers.push_back(fault.pointer);
  return pointers;
}

TEST(ExecuteOptions, AreReadAndTheirFaultsTold) {
  using Pointers = std::vector<std::string>;
  EXPECT_TRUE(execute_options_of(R"({"dryRun": true, "inputs": {}})").dry_run);
  EXPECT_TRUE(execute_options_of(R"({"inputs": {"dryRun": true}})").dry_run);
  EXPECT_FALSE(execute_options_of(R"({"inputs": {}})").dry_run);
  EXPECT_EQ(execute_options_of(R"({"outputs": {"a": {}}})").outputs, Pointers{"a"});
  EXPECT_EQ(faults_of(R"({"dryRun": 1})"), Pointers{"/dryRun"});
  EXPECT_EQ(faults_of(R"({"outputs": {"a": {"transmissionMode": "reference"}}})"),
            Pointers{"/outputs/a/transmissionMode"});
  EXPECT_EQ(faults_of(R"({"response": "raw"})"), Pointers{"/response"});
  EXPECT_TRUE(faults_of(R"({"response": "raw", "outputs": {"a": {}}})").empty());
  EXPECT_EQ(faults_of(R"({"subscriber": {"successUri": "http://x"}})"), Pointers{"/subscriber"});
}

}  // namespace
}  // namespace leda::server
