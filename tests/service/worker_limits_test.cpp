// What one section may use, and what becomes of a job when one of its sections fails.

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <thread>

#include "tests/server/temporary_folder.hpp"
#include "tests/service/leda_process.hpp"
#include "tests/service/region_on_a_bank.hpp"

namespace leda::tests {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;

class WorkerLimits : public testing::Test {
 protected:
  void start(const std::vector<std::string>& options) {
    server = std::make_unique<LedaServer>(folder.path() / "data", options);
    write_bank(folder.path() / "bank.asc");
    std::ifstream file(folder.path() / "bank.asc", std::ios::binary);
    const std::string dem{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    server->client().Post(std::string("/rasters") + bank_query, dem, "image/tiff");
  }

  void submit(const json& region) {
    const auto answer =
        server->client().Post("/processes/map-region/execution", region.dump(), "application/json");
    ASSERT_TRUE(answer);
    ASSERT_EQ(answer->status, 201) << answer->body;
    job = json::parse(answer->body)["jobID"];
  }

  json section(std::size_t index) {
    return server->get("/jobs/" + job + "/sections")["sections"][index];
  }

  static json one_section(double cell_m) {
    json region = bank_region();
    region["inputs"]["sections"] = json::array({region["inputs"]["sections"][0]});
    region["inputs"]["resolution"]["cell_m"] = cell_m;
    return region;
  }

  TemporaryFolder folder;
  std::unique_ptr<LedaServer> server;
  std::string job;
};

TEST_F(WorkerLimits, ASectionThatNeedsMoreMemoryThanItMayUseFailsForMemory) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer's shadow memory leaves no room for a limit";
#endif
  start({"--workers", "1", "--run-memory-gb", "0.3"});
  submit(one_section(0.1));
  EXPECT_EQ(server->wait_for_job(job)["status"], "failed");
  const json failed = section(0);
  EXPECT_EQ(failed["state"], "failed");
  EXPECT_EQ(failed["attempts"], 1) << "it would fail again";
  EXPECT_EQ(failed["reason"],
            "memory: error: the run needs more memory than the 0.3 GB it may use");
}

TEST_F(WorkerLimits, ASectionThatTakesLongerThanItMayFails) {
  // Time in which even a sanitized worker on a busy machine begins, and none ends.
  start({"--workers", "1", "--run-time-limit-s", "5"});
  submit(one_section(0.35));
  EXPECT_EQ(server->wait_for_job(job)["status"], "failed");
  const json failed = section(0);
  EXPECT_EQ(failed["state"], "failed");
  EXPECT_EQ(failed["attempts"], 1);
  const std::string reason = failed["reason"];
  EXPECT_TRUE(reason.starts_with("the run took longer than it may") ||
              reason.starts_with("the run used more processor time than it may"))
      << reason;
}

TEST_F(WorkerLimits, AfterThreeFailuresTheJobGoesOnAndItsZonesSayWhatIsMissing) {
  start({"--workers", "1"});
  json region = bank_region();
  region["inputs"]["sections"] = json::array({{{"along", {{380300, 5113120}, {380300, 5113280}}},
                                               {"spacing_m", 40},
                                               {"upslope_m", 100},
                                               {"downslope_m", 80}}});
  submit(region);
  const std::string doomed = job + "-2-";
  int kills = 0;
  const auto until = std::chrono::steady_clock::now() + 200s;
  while (kills < 3 && std::chrono::steady_clock::now() < until) {
    for (const pid_t worker : server->workers()) {
      const std::string run = run_folder_of(worker).filename().string();
      if (run == doomed + std::to_string(kills + 1)) {
        kill(worker, SIGKILL);
        ++kills;
      }
    }
    std::this_thread::sleep_for(2ms);
  }
  ASSERT_EQ(kills, 3);
  const json status = server->wait_for_job(job);
  EXPECT_EQ(status["status"], "successful");
  const std::string message = status["message"];
  EXPECT_NE(message.find("1 failed"), std::string::npos) << message;

  const json failed = section(2);
  EXPECT_EQ(failed["state"], "failed");
  EXPECT_EQ(failed["attempts"], 3);
  EXPECT_NE(failed["reason"].get<std::string>().find("signal 9"), std::string::npos);
  const std::string own = failed["links"][0]["href"];
  const auto log = server->client().Get(own.substr(server->url().size()) + "/log");
  ASSERT_TRUE(log);
  EXPECT_EQ(log->status, 200);
  EXPECT_EQ(log->body.find(folder.path().string()), std::string::npos) << log->body;

  const json results = server->get("/jobs/" + job + "/results");
  for (const char* kind : {"release_zones", "runout_zones"}) {
    bool named = false;
    for (const auto& zone : results[kind]["features"]) {
      const std::string warnings = zone["properties"]["warnings"];
      named = named || warnings.find(failed["name"].get<std::string>()) != std::string::npos;
    }
    EXPECT_TRUE(named) << kind << " do not say that " << failed["name"]
                       << " is missing: " << results[kind].dump(2);
  }

  // Only what failed is run again, and the zones are whole then.
  EXPECT_EQ(server->client().Post("/jobs/" + job + "/retry")->status, 200);
  EXPECT_EQ(server->wait_for_job(job)["status"], "successful");
  EXPECT_EQ(section(2)["state"], "finished");
  EXPECT_EQ(section(1)["attempts"], 1);
}

}  // namespace
}  // namespace leda::tests
