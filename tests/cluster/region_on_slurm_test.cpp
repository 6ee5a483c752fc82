// A region mapped by a server whose runs go out to Slurm: the same results as the local pool's,
// although the node dies, the controller restarts and the server is killed meanwhile.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <thread>

#include "tests/cluster/one_node_slurm.hpp"
#include "tests/service/leda_process.hpp"
#include "tests/service/region_on_a_bank.hpp"

namespace leda::tests {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;

// Under a sanitizer a run takes ten times as long.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double coarser = 2.5;
#else
constexpr double coarser = 1;
#endif

class RegionOnSlurm : public testing::Test {
 protected:
  void SetUp() override {
    if (const auto missing = OneNodeSlurm::missing(); !missing.empty()) GTEST_SKIP() << missing;
    OneNodeSlurm::instance();
    write_bank(folder.path() / "bank.asc");
    std::filesystem::create_directory(folder.path() / "shared");
  }

  /// A server that was killed leaves its runs to Slurm, where the next test would wait for them.
  void TearDown() override {
    if (OneNodeSlurm::missing().empty()) OneNodeSlurm::instance().clear();
  }

  std::vector<std::string> on_slurm() const {
    return {"--executor",
            "slurm",
            "--run-memory-gb",
            "1",
            "--slurm-look-every-s",
            "0.3",
            "--slurm-settle-s",
            "1",
            "--slurm-shared-folder",
            (folder.path() / "shared").string(),
            "--slurm-completion-file",
            OneNodeSlurm::instance().completion_file().string()};
  }

  /// @param ensemble null: none
  std::string submit(LedaServer& server, double cell_m, const json& ensemble = nullptr) const {
    std::ifstream file(folder.path() / "bank.asc", std::ios::binary);
    const std::string dem{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    server.client().Post(std::string("/rasters") + bank_query, dem, "image/tiff");
    json region = bank_region();
    region["inputs"]["resolution"]["cell_m"] = cell_m;
    if (!ensemble.is_null()) region["inputs"]["ensemble"] = ensemble;
    const auto answer =
        server.client().Post("/processes/map-region/execution", region.dump(), "application/json");
    if (!answer || answer->status != 201) throw std::runtime_error("the job was not accepted");
    return json::parse(answer->body)["jobID"];
  }

  /// Everything a section's result says but what it cost, and the zones.
  static json what_came_out(LedaServer& server, const std::string& job) {
    json results = server.get("/jobs/" + job + "/results");
    for (auto& section : results["sections"]) {
      for (const char* own :
           {"run_time_s", "ns_per_particle_step", "attempts", "run", "log", "links"}) {
        section.erase(own);
      }
    }
    for (const char* layer : {"release_zones", "runout_zones", "probability_zones"}) {
      for (auto& zone : results[layer]["features"]) {
        zone.erase("id");
        for (const char* own : {"job", "made_by", "leda_job"}) zone["properties"].erase(own);
      }
    }
    return {{"sections", results["sections"]},
            {"release_zones", results["release_zones"]["features"]},
            {"runout_zones", results["runout_zones"]["features"]},
            {"probability_zones", results["probability_zones"]["features"]}};
  }

  static json how_sure(LedaServer& server, const std::string& job) {
    json ensembles = json::array();
    for (const char* section : {"AA%27", "BB%27", "S001", "S002"}) {
      ensembles.push_back(server.get("/jobs/" + job + "/sections/" + section + "/ensemble"));
      ensembles.back().erase("core_s");
    }
    return ensembles;
  }

  json local_results(double cell_m) const {
    LedaServer server(folder.path() / "local", {"--workers", "2"});
    const std::string job = submit(server, cell_m);
    EXPECT_EQ(server.wait_for_job(job)["status"], "successful");
    return what_came_out(server, job);
  }

  /// Waits until so many runs go on at the same time, by what they have written.
  bool wait_for_progress(int wanted = 1) const {
    const auto until = std::chrono::steady_clock::now() + 60s;
    while (std::chrono::steady_clock::now() < until) {
      int going = 0;
      for (const auto& run :
           std::filesystem::directory_iterator(folder.path() / "shared" / "runs")) {
        if (exists(run.path() / "progress.json") && !exists(run.path() / "result.json")) ++going;
      }
      if (going >= wanted) return true;
      std::this_thread::sleep_for(20ms);
    }
    return false;
  }

  TemporaryFolder folder;
};

TEST_F(RegionOnSlurm, GivesTheLocalPoolsResultsAlthoughNodeAndControllerFail) {
  constexpr double cell_m = 0.6 * coarser;
  LedaServer server(folder.path() / "data", on_slurm());
  const std::string job = submit(server, cell_m);
  // With every core busy nothing is being launched: of a launch that a dying slurmd lost, Slurm
  // itself hears only when the node registers again, minutes later.
  ASSERT_TRUE(wait_for_progress(std::min(4, OneNodeSlurm::instance().cores())));
  OneNodeSlurm::instance().call("kill", "node");
  std::this_thread::sleep_for(1s);
  OneNodeSlurm::instance().call("start", "node");
  OneNodeSlurm::instance().call("stop", "controller");
  const auto while_down = server.get("/jobs/" + job);
  EXPECT_EQ(while_down["status"], "running");
  std::this_thread::sleep_for(2s);
  OneNodeSlurm::instance().call("start", "controller");
  const json status = server.wait_for_job(job);
  EXPECT_EQ(status["status"], "successful") << status.dump(2);
  EXPECT_EQ(status["message"], "4 sections: 4 with a result");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "data" / "runs"));
  EXPECT_EQ(what_came_out(server, job), local_results(cell_m));
}

TEST_F(RegionOnSlurm, AKilledServerAdoptsItsRuns) {
  std::string job;
  {
    LedaServer server(folder.path() / "data", on_slurm());
    job = submit(server, coarser);
    ASSERT_TRUE(wait_for_progress());
    server.kill_hard();
  }
  LedaServer server(folder.path() / "data", on_slurm());
  EXPECT_EQ(server.wait_for_job(job)["status"], "successful");
  const json sections = server.get("/jobs/" + job + "/sections")["sections"];
  ASSERT_EQ(sections.size(), 4U);
  for (const auto& section : sections) {
    EXPECT_EQ(section["state"], "finished");
    EXPECT_EQ(section["attempts"], 1) << "it was running, and was adopted: " << section.dump(1);
  }
}

TEST_F(RegionOnSlurm, MembersGiveTheLocalPoolsNumbersAlthoughTheServerIsKilled) {
  const json ensemble = json::parse(R"({
    "inputs": [{"name": "su", "path": "/soil/materials/*/peak_strength_kPa", "apply": "scale",
                "distribution": {"type": "lognormal", "mean": 1, "cov": 0.3}}],
    "sampling": {"replicates": 4},
    "stop": {"min_members": 16, "max_members": 16, "half_width": 0.01}})");
  constexpr double cell_m = 2;
  std::string job;
  {
    LedaServer server(folder.path() / "data", on_slurm());
    job = submit(server, cell_m, ensemble);
    ASSERT_TRUE(wait_for_progress());
    server.kill_hard();
  }
  LedaServer server(folder.path() / "data", on_slurm());
  const json status = server.wait_for_job(job);
  EXPECT_EQ(status["message"], "4 sections: 4 with a result; 64 members: 64 with a result");
  LedaServer local(folder.path() / "local", {"--workers", "2"});
  const std::string same = submit(local, cell_m, ensemble);
  EXPECT_EQ(local.wait_for_job(same)["status"], "successful");
  EXPECT_EQ(how_sure(server, job), how_sure(local, same));
  EXPECT_EQ(what_came_out(server, job), what_came_out(local, same));
}

TEST_F(RegionOnSlurm, ADismissedJobLeavesTheQueueEmpty) {
  LedaServer server(folder.path() / "data", on_slurm());
  const std::string job = submit(server, 0.5 * coarser);
  ASSERT_TRUE(wait_for_progress());
  EXPECT_EQ(server.client().Delete("/jobs/" + job)->status, 200);
  const auto notes = folder.path() / "shared" / "arrays";
  const auto arrays = [&] {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(notes)) {
      count += entry.path().extension() == ".json" ? 1 : 0;
    }
    return count;
  };
  const auto until = std::chrono::steady_clock::now() + 60s;
  while (arrays() > 0 && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(50ms);
  }
  EXPECT_EQ(arrays(), 0U);
  EXPECT_EQ(server.get("/jobs/" + job)["status"], "dismissed");
}

}  // namespace
}  // namespace leda::tests
