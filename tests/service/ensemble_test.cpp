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
  EXPECT_NE(done.errors.find(" runs done"), std::string::npos) << done.errors;
  const json document = json::parse(done.text);
  EXPECT_EQ(document["members"], 32);
  EXPECT_NE(document["warnings"].dump().find("cells high"), std::string::npos) << document;
  EXPECT_NE(document["warnings"].dump().find(" of 32 members"), std::string::npos) << document;
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

// The seed of a member is that of its field: what stands as it is on average falls in some of them.
TEST_F(EnsembleOfABank, MembersDifferByTheirFieldsOfStrength) {
  json of = bank();
  json& clay = of["materials"]["clay"];
  clay["peak_strength_kPa"] = 30;
  clay["field"] = {{"cov", 0.3}, {"horizontal_m", 10}, {"vertical_m", 2}};
  of["ensemble"]["inputs"] = json::parse(R"([
      {"name": "variation", "path": "/materials/clay/field/cov", "apply": "set",
       "distribution": {"type": "uniform", "min": 0.29, "max": 0.31}}])");
  of["ensemble"]["stop"] = {{"min_members", 16}, {"max_members", 16}};
  of["ensemble"].erase("check");
  const Output done = run_leda({"ensemble", file(of), "--out", out().string(), "--json"});
  ASSERT_EQ(done.exit_code, 0) << done.errors;
  const json by_status = json::parse(done.text)["by_status"];
  EXPECT_GT(by_status.value("stable", 0), 2) << by_status;
  EXPECT_GT(by_status.value("at-rest", 0), 2) << by_status;
  const json member = json::parse(text_of(out() / "members" / "member-0" / "result.json"));
  EXPECT_NE(member["warnings"].dump().find("strength of clay varies"), std::string::npos);

  clay["field"]["cov"] = 1e-6;
  of["ensemble"]["inputs"][0]["distribution"] = {{"type", "uniform"}, {"min", 1e-6}, {"max", 2e-6}};
  const Output none =
      run_leda({"ensemble", file(of), "--out", (folder.path() / "none").string(), "--json"});
  ASSERT_EQ(none.exit_code, 0) << none.errors;
  EXPECT_EQ(json::parse(none.text)["by_status"]["stable"], 16);
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
  EXPECT_EQ(server.client().Get("/jobs/" + job + "/members?f=csv")->status, 404)
      << "those that ended so far would look like all";
  ASSERT_EQ(server.wait_for_job(job)["status"], "successful");
  const json document = server.get(ensemble_path);
  EXPECT_EQ(document["ended_by"], "half-width");
  EXPECT_EQ(document["members"], 16);
  EXPECT_NE(document["warnings"].dump().find("cells high"), std::string::npos) << document;
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
  const json warning = json::parse(dry.text)["warnings"].at(0);
  EXPECT_NE(dry.errors.find("warning: " + warning.get<std::string>()), std::string::npos);
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
