// The study by its two ways, HTTP and the command line, on a bank that is simulated in moments.

#include <gtest/gtest.h>

#include <fstream>

#include "tests/server/temporary_folder.hpp"
#include "tests/service/leda_process.hpp"
#include "tests/service/small_bank.hpp"

namespace leda::tests {
namespace {

using nlohmann::json;

json inputs() {
  return {{"name", "bank study"},      {"case", small_bank()}, {"cell_m", {1, 1.2}},
          {"particles_per_cell", {4}}, {"seeds", 1},           {"reference", "finest"}};
}

class StudyOfABank : public testing::Test {
 protected:
  std::string file(const char* name, const json& document) const {
    const auto path = folder.path() / name;
    std::ofstream(path) << document.dump();
    return path.string();
  }
  std::string out() const { return (folder.path() / "out").string(); }

  TemporaryFolder folder;
};

TEST_F(StudyOfABank, ComesOverHttpAsAJobWhoseResultsAreTheStudy) {
  LedaServer server(folder.path() / "data", {"--workers", "2"});
  const json described = server.get("/processes/resolution-study");
  EXPECT_EQ(described["inputs"]["cell_m"]["minOccurs"], 1);
  EXPECT_TRUE(described["definitions"].contains("case"));

  const std::string path = "/processes/resolution-study/execution";
  json wrong = inputs();
  wrong["cell_m"] = {1, -1};
  wrong["time_step_factor"] = {0.65, 2};
  wrong["workers"] = 4;
  const auto refused =
      server.client().Post(path, json{{"inputs", wrong}}.dump(), "application/json");
  ASSERT_EQ(refused->status, 400);
  EXPECT_NE(refused->body.find("/inputs/cell_m/1"), std::string::npos) << refused->body;
  EXPECT_NE(refused->body.find("/inputs/time_step_factor/1"), std::string::npos) << refused->body;
  EXPECT_NE(refused->body.find("/inputs/workers"), std::string::npos) << refused->body;

  const auto dry = server.client().Post(path, json{{"inputs", inputs()}, {"dryRun", true}}.dump(),
                                        "application/json");
  ASSERT_EQ(dry->status, 200) << dry->body;
  const json coarse = json::parse(dry->body)["sections"].at(0);
  EXPECT_NE(coarse["warnings"].dump().find("cells high"), std::string::npos) << coarse;

  const auto accepted =
      server.client().Post(path, json{{"inputs", inputs()}}.dump(), "application/json");
  ASSERT_EQ(accepted->status, 201) << accepted->body;
  const std::string job = json::parse(accepted->body)["jobID"];
  EXPECT_EQ(server.get("/jobs/" + job + "/sections")["sections"].size(), 4U);
  ASSERT_EQ(server.wait_for_job(job)["status"], "successful");

  const json study = server.get("/jobs/" + job + "/results");
  ASSERT_EQ(study["runs"].size(), 4U);
  EXPECT_EQ(study["runs"][0]["name"], "cell-1.2-particles-4-seed-0");
  EXPECT_EQ(study["settings"].size(), 2U);
  for (const json& run : study["runs"]) EXPECT_GT(run["run_time_s"], 0) << run;
  const auto drawing = server.client().Get("/jobs/" + job + "/results?f=svg");
  EXPECT_EQ(drawing->status, 200);
  EXPECT_TRUE(drawing->body.starts_with("<svg")) << drawing->body;
  EXPECT_EQ(server.client().Get("/jobs/" + job + "/results?f=csv")->status, 200);
  EXPECT_EQ(server.client().Get("/jobs/" + job + "/results?f=gpkg")->status, 400);
}

TEST_F(StudyOfABank, ComesOnTheCommandLineAndGoesOnWhereItWas) {
  json document = inputs();
  document.erase("case");
  document["case_file"] = "bank.json";
  document["workers"] = 2;
  file("bank.json", small_bank());
  const std::string study = file("study.json", document);
  const Output first = run_leda({"study", study, "--out", out()});
  ASSERT_EQ(first.exit_code, 0) << first.errors;
  EXPECT_NE(first.text.find("1.2 m, 4 particles"), std::string::npos) << first.text;
  EXPECT_NE(first.text.find("warning: 1.2 m, 4 particles: "), std::string::npos) << first.text;
  EXPECT_EQ(first.errors.find("warning: 1.2 m, 4 particles: the bank is "), 0U) << first.errors;
  for (const char* name : {"study.json", "study.csv", "study.svg"}) {
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / name)) << name;
  }
  // A run that is gone is run again, those that stand are the same to the last digit of their time.
  const auto runs = folder.path() / "out" / "runs";
  std::filesystem::remove(runs / "cell-1-particles-4-seed-1" / "result.json");
  const json before = json::parse(std::ifstream(folder.path() / "out" / "study.json"));
  const Output second = run_leda({"study", study, "--out", out(), "--json"});
  ASSERT_EQ(second.exit_code, 0) << second.errors;
  EXPECT_NE(second.errors.find("4 of 4 runs done"), std::string::npos) << second.errors;
  const json after = json::parse(second.text);
  ASSERT_EQ(after["runs"].size(), 4U);
  EXPECT_EQ(after["runs"][2], before["runs"][2]);
  EXPECT_EQ(after["runs"][3]["status"], before["runs"][3]["status"]);
  // Another time step is four runs more; those of the case's own are found.
  document["time_step_factor"] = {0.65, 0.8};
  const Output third = run_leda({"study", file("study.json", document), "--out", out()});
  ASSERT_EQ(third.exit_code, 0) << third.errors;
  EXPECT_NE(third.errors.find("8 of 8 runs done (4 found)"), std::string::npos) << third.errors;
  EXPECT_NE(third.text.find("1.2 m, 4 particles, step 0.8"), std::string::npos) << third.text;
  const json wider = json::parse(std::ifstream(folder.path() / "out" / "study.json"));
  ASSERT_EQ(wider["runs"].size(), 8U);
  EXPECT_EQ(wider["runs"][0]["name"], "cell-1.2-particles-4-step-0.8-seed-0");
  EXPECT_GT(wider["runs"][2]["steps"], wider["runs"][0]["steps"]);
  EXPECT_TRUE(std::filesystem::exists(runs / "cell-1-particles-4-step-0.8-seed-1" / "result.json"));
}

TEST_F(StudyOfABank, FaultsAreListedWithTheirPointers) {
  json document = inputs();
  document["case"]["base_m"] = 100;
  document["seeds"] = -1;
  const Output output = run_leda({"study", file("study.json", document), "--out", out()});
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_NE(output.errors.find("/case/base_m"), std::string::npos) << output.errors;
  EXPECT_NE(output.errors.find("/seeds"), std::string::npos) << output.errors;
  EXPECT_FALSE(std::filesystem::exists(out()));
}

}  // namespace
}  // namespace leda::tests
