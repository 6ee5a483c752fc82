// kill -9 of the server or of a worker at any moment: nothing is lost, nothing counted twice.

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

class Kill : public testing::Test {
 protected:
  std::string submit(LedaServer& server, const json& region = slower_region()) {
    write_bank(folder.path() / "bank.asc");
    std::ifstream file(folder.path() / "bank.asc", std::ios::binary);
    const std::string dem{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    server.client().Post(std::string("/rasters") + bank_query, dem, "image/tiff");
    const auto answer =
        server.client().Post("/processes/map-region/execution", region.dump(), "application/json");
    if (!answer || answer->status != 201) throw std::runtime_error("the job was not accepted");
    return json::parse(answer->body)["jobID"];
  }

  /// Fine enough that there is time to kill it.
  static json slower_region() {
    json region = bank_region();
    region["inputs"]["resolution"]["cell_m"] = 1.5;
    return region;
  }

  static std::vector<pid_t> wait_for_workers(const LedaServer& server) {
    const auto until = std::chrono::steady_clock::now() + 20s;
    std::vector<pid_t> workers;
    while (workers.empty() && std::chrono::steady_clock::now() < until) {
      workers = server.workers();
      std::this_thread::sleep_for(5ms);
    }
    return workers;
  }

  /// A job is booked as running once the first runs of it were started: "accepted" may linger.
  static bool is_open(LedaServer& server, const std::string& job) {
    const json status = server.get("/jobs/" + job)["status"];
    return status == "accepted" || status == "running";
  }

  static void expect_all_results_once(LedaServer& server, const std::string& job) {
    const json status = server.wait_for_job(job);
    EXPECT_EQ(status["status"], "successful") << status.dump(2);
    const json sections = server.get("/jobs/" + job + "/sections")["sections"];
    ASSERT_EQ(sections.size(), 4U);
    for (const auto& section : sections) EXPECT_EQ(section["state"], "finished") << section.dump(2);
    const json results = server.get("/jobs/" + job + "/results");
    EXPECT_EQ(results["release_zones"]["features"].size(), 3U);
    EXPECT_EQ(server.get("/jobs")["numberMatched"], 1);
  }

  TemporaryFolder folder;
};

TEST_F(Kill, TheServerAgainAndAgain) {
  std::string job;
  for (int kills = 0; kills < 4; ++kills) {
    LedaServer server(folder.path() / "data", {"--workers", "2"});
    if (job.empty()) job = submit(server);
    const auto workers = wait_for_workers(server);
    std::this_thread::sleep_for(50ms * (kills + 1));
    EXPECT_TRUE(!workers.empty() && is_open(server, job)) << "there was nothing to kill";
    server.kill_hard();
    std::this_thread::sleep_for(200ms);
    for (const pid_t worker : workers) EXPECT_FALSE(is_alive(worker));
  }
  LedaServer server(folder.path() / "data", {"--workers", "2"});
  expect_all_results_once(server, job);
}

TEST_F(Kill, TheServerRightAfterItsReply) {
  std::string job;
  {
    LedaServer server(folder.path() / "data");
    job = submit(server, bank_region());
    server.kill_hard();
  }
  LedaServer server(folder.path() / "data", {"--workers", "2"});
  expect_all_results_once(server, job);
}

TEST_F(Kill, Workers) {
  LedaServer server(folder.path() / "data", {"--workers", "2"});
  const std::string job = submit(server);
  for (const pid_t worker : wait_for_workers(server)) kill(worker, SIGKILL);
  expect_all_results_once(server, job);
  int tries = 0;
  const json sections = server.get("/jobs/" + job + "/sections")["sections"];
  for (const auto& section : sections) {
    tries += section["attempts"].get<int>();
  }
  EXPECT_GT(tries, 4);
}

TEST_F(Kill, ACleanEndTakesLessThanFiveSecondsAndLosesNothing) {
  std::string job;
  {
    LedaServer server(folder.path() / "data", {"--workers", "2"});
    job = submit(server);
    const auto workers = wait_for_workers(server);
    EXPECT_LT(server.end(), 5);
    for (const pid_t worker : workers) EXPECT_FALSE(is_alive(worker));
  }
  LedaServer server(folder.path() / "data", {"--workers", "2"});
  expect_all_results_once(server, job);
}

// Texts of one kind of file, over all run folders.
std::vector<std::string> in_runs(const std::filesystem::path& data, const std::string& name) {
  std::vector<std::string> texts;
  for (const auto& run : std::filesystem::directory_iterator(data / "runs")) {
    std::ifstream in(run.path() / name, std::ios::binary);
    if (in)
      texts.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return texts;
}

TEST_F(Kill, ACleanEndLeavesCheckpointsAndTheNextServerGoesOnFromThem) {
  const auto data = folder.path() / "data";
  std::string job;
  json region = slower_region();
  region["inputs"]["resolution"]["cell_m"] = 1;
  {
    LedaServer server(data, {"--workers", "2"});
    job = submit(server, region);
    const auto moves = [&] {
      int moving = 0;
      for (const auto& text : in_runs(data, "progress.json")) {
        const auto progress = json::parse(text, nullptr, false);
        moving += progress.is_object() && progress.value("time_s", 0.0) > 0.2 ? 1 : 0;
      }
      return moving == 2;
    };
    const auto until = std::chrono::steady_clock::now() + 120s;
    while (!moves() && std::chrono::steady_clock::now() < until) std::this_thread::sleep_for(10ms);
    ASSERT_TRUE(moves());
    EXPECT_LT(server.end(), 5);
  }
  EXPECT_EQ(in_runs(data, "checkpoint.bin").size(), 2U);
  LedaServer server(data, {"--workers", "2"});
  const auto goes_on = [&] {
    int runs = 0;
    for (const auto& log : in_runs(data, "log.txt")) {
      runs += log.find("goes on from its checkpoint") != std::string::npos ? 1 : 0;
    }
    return runs;
  };
  expect_all_results_once(server, job);
  EXPECT_EQ(goes_on(), 2);
  EXPECT_TRUE(in_runs(data, "checkpoint.bin").empty()) << "left behind";
}

TEST_F(Kill, TheRestartedServerGivesTheSameResultsAsOneThatWasNeverKilled) {
  const auto distances = [&](const std::string& data, bool with_kill) {
    std::string job;
    if (with_kill) {
      LedaServer server(folder.path() / data, {"--workers", "2"});
      job = submit(server);
      wait_for_workers(server);
      std::this_thread::sleep_for(300ms);
      server.kill_hard();
    }
    LedaServer server(folder.path() / data, {"--workers", "2"});
    if (job.empty()) job = submit(server);
    server.wait_for_job(job);
    std::vector<double> all;
    const json sections = server.get("/jobs/" + job + "/sections")["sections"];
    for (const auto& section : sections) {
      all.push_back(section["crest_to_crest_retrogression_m"]);
      all.push_back(section["runout_m"]);
    }
    return all;
  };
  const auto killed = distances("killed", true);
  EXPECT_EQ(killed.size(), 8U);
  EXPECT_EQ(killed, distances("quiet", false));
}

}  // namespace
}  // namespace leda::tests
