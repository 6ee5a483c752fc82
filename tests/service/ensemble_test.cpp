// An ensemble on the command line, over a bank that is simulated in moments.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "tests/server/temporary_folder.hpp"
#include "tests/service/leda_process.hpp"
#include "tests/service/small_bank.hpp"

namespace leda::tests {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

json bank() {
  json of = small_bank();
  of["ensemble"] = json::parse(R"({
      "inputs": [{"name": "su", "path": "/materials/clay/peak_strength_kPa", "apply": "scale",
                  "distribution": {"type": "lognormal", "mean": 0.8, "cov": 0.4}}],
      "sampling": {"replicates": 4},
      "stop": {"min_members": 16, "max_members": 32, "half_width": 0.01},
      "check": {"members": 2, "seeds": 2, "cell_m": 0.8}})");
  return of;
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

class EnsembleOfABank : public testing::Test {
 protected:
  std::string file(const json& document) const {
    const auto path = folder.path() / "bank.json";
    std::ofstream(path) << document.dump();
    return path.string();
  }
  fs::path out() const { return folder.path() / "out"; }

  TemporaryFolder folder;
};

TEST_F(EnsembleOfABank, LeavesNumbersMembersAndADrawing) {
  const Output done = run_leda({"ensemble", file(bank()), "--out", out().string(), "--json"});
  ASSERT_EQ(done.exit_code, 0) << done.errors;
  const json document = json::parse(done.text);
  EXPECT_EQ(document["members"], 32);
  EXPECT_EQ(document["ended_by"], "max-members");
  EXPECT_GT(document["probability_of_sliding"]["value"], 0);
  EXPECT_EQ(document["retrogression"]["chance"]["runs"], 4);
  EXPECT_GT(document["by_status"]["stable"], 0);
  EXPECT_EQ(document["retrogression"]["quantiles"][0]["distance_is"], "lower-bound")
      << "25 m of ground behind the crest";
  const std::string csv = text_of(out() / "members.csv");
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 32 + 2 * 2);
  EXPECT_NE(csv.find(",1,finer,0,"), std::string::npos) << csv;
  EXPECT_TRUE(text_of(out() / "ensemble.svg").starts_with("<svg"));
  EXPECT_FALSE(fs::exists(out() / "members" / "member-0" / "fields.h5"));
}

/// Without what differs from one time to the next.
json result_of(const fs::path& run) {
  json result = json::parse(text_of(run / "result.json"));
  result.erase("run_time_s");
  result.erase("ns_per_particle_step");
  return result;
}

TEST_F(EnsembleOfABank, AMemberRunAgainAloneGivesTheSame) {
  ASSERT_EQ(run_leda({"ensemble", file(bank()), "--out", out().string()}).exit_code, 0);
  const auto member = out() / "members" / "member-5";
  const auto alone = folder.path() / "alone";
  const Output again =
      run_leda({"simulate", (member / "case.json").string(), "--out", alone.string()});
  ASSERT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_EQ(result_of(alone), result_of(member));
  EXPECT_EQ(text_of(alone / "profile_after.csv"), text_of(member / "profile_after.csv"));
}

TEST_F(EnsembleOfABank, GoesOnWhereItWasKilled) {
  const std::string name = file(bank()), undisturbed = (folder.path() / "whole").string();
  ASSERT_EQ(run_leda({"ensemble", name, "--out", undisturbed}).exit_code, 0);
  const pid_t process = fork();
  if (process == 0) {
    execl(LEDA_PROGRAM, LEDA_PROGRAM, "ensemble", name.c_str(), "--out", out().c_str(), "--workers",
          "1", nullptr);
    _exit(127);
  }
  while (!fs::exists(out() / "members" / "member-3" / "result.json")) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  kill(process, SIGKILL);
  int status = 0;
  waitpid(process, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_FALSE(fs::exists(out() / "ensemble.json"));
  const auto first = fs::last_write_time(out() / "members" / "member-0" / "result.json");
  ASSERT_EQ(run_leda({"ensemble", name, "--out", out().string()}).exit_code, 0);
  EXPECT_EQ(fs::last_write_time(out() / "members" / "member-0" / "result.json"), first);
  json whole = json::parse(text_of(folder.path() / "whole" / "ensemble.json"));
  json resumed = json::parse(text_of(out() / "ensemble.json"));
  for (json* document : {&whole, &resumed}) {
    for (const char* of_the_day : {"core_s", "date"}) document->erase(of_the_day);
  }
  EXPECT_EQ(whole, resumed);
}

TEST_F(EnsembleOfABank, ComesOverHttpAsAJobOfItsMembers) {
  LedaServer server(folder.path() / "data", {"--workers", "2"});
  json of = bank(), ensemble = of["ensemble"];
  of.erase("ensemble");
  ensemble["stop"] = {{"min_members", 16}, {"max_members", 64}, {"half_width", 0.5}};
  ensemble.erase("check");
  const json body{{"inputs", {{"case", of}, {"ensemble", ensemble}}}};
  const auto accepted = server.client().Post("/processes/simulate-section/execution", body.dump(),
                                             "application/json");
  ASSERT_EQ(accepted->status, 201) << accepted->body;
  const std::string job = json::parse(accepted->body)["jobID"];
  const std::string ensemble_path = "/jobs/" + job + "/sections/bank/ensemble";
  EXPECT_EQ(server.client().Get(ensemble_path)->status, 404);
  ASSERT_EQ(server.wait_for_job(job)["status"], "successful");
  const json document = server.get(ensemble_path);
  EXPECT_EQ(document["ended_by"], "half-width");
  EXPECT_EQ(document["members"], 16);
  const auto drawing = server.client().Get(ensemble_path + "?f=svg");
  EXPECT_TRUE(drawing->body.starts_with("<svg")) << drawing->body;
  EXPECT_EQ(server.client().Get("/jobs/" + job + "/sections/other/ensemble")->status, 404);
  const auto csv = server.client().Get("/jobs/" + job + "/members?f=csv");
  const auto lines = std::ranges::count(csv->body, '\n');
  EXPECT_GE(lines, 1 + 16);
  EXPECT_LT(lines, 1 + 64) << "all were run, though 16 are sure enough";
}

TEST_F(EnsembleOfABank, ADryRunTellsItsCostAndRunsNothing) {
  const Output dry =
      run_leda({"ensemble", file(bank()), "--out", out().string(), "--dry-run", "--json"});
  ASSERT_EQ(dry.exit_code, 0) << dry.errors;
  const json estimate = json::parse(dry.text)["estimate"];
  EXPECT_EQ(estimate["members_at_least"], 16);
  EXPECT_EQ(estimate["runs_at_most"], 32 + 2 * 2);
  EXPECT_GT(estimate["core_hours_at_most"], estimate["core_hours_at_least"]);
  EXPECT_FALSE(fs::exists(out()));
}

TEST_F(EnsembleOfABank, FaultsAreListedWithTheirPointers) {
  json document = bank();
  document["ensemble"]["inputs"][0]["path"] = "/materials/sand/peak_strength_kPa";
  document["ensemble"]["stop"]["max_members"] = 1'000'000;
  const Output output = run_leda({"ensemble", file(document), "--out", out().string()});
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_NE(output.errors.find("/ensemble/inputs/0/path"), std::string::npos) << output.errors;
  EXPECT_NE(output.errors.find("/ensemble/stop/max_members"), std::string::npos) << output.errors;
  EXPECT_FALSE(fs::exists(out()));
}

}  // namespace
}  // namespace leda::tests
