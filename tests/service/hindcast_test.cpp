// A hindcast by its two ways, HTTP and the command line, on banks that are simulated in moments.

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

/// With room behind the crest: how far it slides depends on the remolded strength.
json wide_bank() {
  json bank = small_bank();
  bank["ground"][0] = {-15, 10};
  return bank;
}

json event(const char* name, double seen_m) {
  return {{"name", name},
          {"case", wide_bank()},
          {"observed", {{"retrogression_m", {{"value", seen_m}, {"sd_ln", 0.1}}}}}};
}

/// @param sd_ln of the discrepancy: with a small one a second wave is wanted
json hindcast(double sd_ln = 0.3) {
  return {{"name", "banks"},
          {"events", {event("A", 9), event("B", 12)}},
          {"ensemble",
           {{"inputs",
             {{{"name", "remolded"},
               {"path", "/materials/clay/softening/remolded_strength_kPa"},
               {"apply", "scale"},
               {"scope", "region"},
               {"distribution", {{"type", "uniform"}, {"min", 1}, {"max", 9}}}},
              {{"name", "weight"},
               {"path", "/materials/clay/unit_weight_kN_m3"},
               {"distribution", {{"type", "uniform"}, {"min", 16}, {"max", 18}}}}}}}},
          {"discrepancy", {{"sd_ln", sd_ln}}},
          {"members", 16},
          {"waves", 2}};
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

class HindcastOfBanks : public testing::Test {
 protected:
  std::string file(const char* name, const json& document) const {
    const auto path = folder.path() / name;
    std::ofstream(path) << document.dump();
    return path.string();
  }
  fs::path out() const { return folder.path() / "out"; }

  TemporaryFolder folder;
};

TEST_F(HindcastOfBanks, LeavesNumbersMembersAndADrawing) {
  json document = hindcast();
  document["events"][1].erase("case");
  document["events"][1]["case_file"] = "bank.json";
  file("bank.json", wide_bank());
  const Output done =
      run_leda({"hindcast", file("hindcast.json", document), "--out", out().string(), "--json"});
  ASSERT_EQ(done.exit_code, 0) << done.errors;
  EXPECT_NE(done.errors.find("wave "), std::string::npos) << done.errors;
  const json said = json::parse(done.text);
  EXPECT_EQ(said, json::parse(text_of(out() / "hindcast.json")));
  EXPECT_EQ(said["slides"].size(), 2U);
  EXPECT_GT(said["weights"]["effective_members"], 1);
  EXPECT_EQ(said["retrogression"]["of"], 2);
  const std::size_t waves = said["waves"];
  const std::string csv = text_of(out() / "members.csv");
  EXPECT_GE(std::ranges::count(csv, '\n'), std::ptrdiff_t(1 + waves * 32));
  EXPECT_TRUE(text_of(out() / "hindcast.svg").starts_with("<svg"));
  EXPECT_FALSE(fs::exists(out() / "members" / "wave-1-slide-1-member-0" / "fields.h5"));

  json ensemble = wide_bank();
  ensemble["ensemble"] = {{"inputs", said["posterior"]["inputs"]}};
  const Output taken = run_leda({"ensemble", file("next.json", ensemble), "--out",
                                 (folder.path() / "next").string(), "--dry-run"});
  EXPECT_EQ(taken.exit_code, 0) << taken.errors;
}

TEST_F(HindcastOfBanks, GoesOnWhereItWasKilled) {
  const std::string name = file("hindcast.json", hindcast(0.05));
  const std::string undisturbed = (folder.path() / "whole").string();
  ASSERT_EQ(run_leda({"hindcast", name, "--out", undisturbed}).exit_code, 0);
  const pid_t process = fork();
  if (process == 0) {
    execl(LEDA_PROGRAM, LEDA_PROGRAM, "hindcast", name.c_str(), "--out", out().c_str(), "--workers",
          "1", nullptr);
    _exit(127);
  }
  while (!fs::exists(out() / "members" / "wave-2-slide-1-member-17" / "result.json")) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  kill(process, SIGKILL);
  int status = 0;
  waitpid(process, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  const auto result = out() / "members" / "wave-2-slide-1-member-16" / "result.json";
  const auto first = fs::last_write_time(result);
  ASSERT_EQ(run_leda({"hindcast", name, "--out", out().string()}).exit_code, 0);
  EXPECT_EQ(fs::last_write_time(result), first);
  json whole = json::parse(text_of(folder.path() / "whole" / "hindcast.json"));
  json resumed = json::parse(text_of(out() / "hindcast.json"));
  for (json* document : {&whole, &resumed}) {
    for (const char* of_the_day : {"core_s", "date"}) document->erase(of_the_day);
  }
  EXPECT_EQ(whole, resumed);
  EXPECT_EQ(whole["waves"], 2);
}

TEST_F(HindcastOfBanks, ComesOverHttpWithTheSameAnswer) {
  LedaServer server(folder.path() / "data", {"--workers", "2"});
  const json inputs = hindcast(0.05);
  const auto accepted = server.client().Post("/processes/hindcast/execution",
                                             json{{"inputs", inputs}}.dump(), "application/json");
  ASSERT_EQ(accepted->status, 201) << accepted->body;
  const std::string job = json::parse(accepted->body)["jobID"];
  ASSERT_EQ(server.wait_for_job(job)["status"], "successful");
  json said = server.get("/jobs/" + job + "/results");
  EXPECT_EQ(said["waves"], 2);
  const auto drawing = server.client().Get("/jobs/" + job + "/results?f=svg");
  EXPECT_TRUE(drawing->body.starts_with("<svg")) << drawing->body;
  const auto csv = server.client().Get("/jobs/" + job + "/results?f=csv");
  EXPECT_GE(std::ranges::count(csv->body, '\n'), 1 + 2 * 32);

  ASSERT_EQ(
      run_leda({"hindcast", file("hindcast.json", inputs), "--out", out().string()}).exit_code, 0);
  json in_a_folder = json::parse(text_of(out() / "hindcast.json"));
  for (json* document : {&said, &in_a_folder}) {
    for (const char* of_the_day : {"core_s", "date", "version"}) document->erase(of_the_day);
  }
  EXPECT_EQ(said, in_a_folder);
}

TEST_F(HindcastOfBanks, ADryRunTellsItsCostAndRunsNothing) {
  const Output dry = run_leda({"hindcast", file("hindcast.json", hindcast()), "--out",
                               out().string(), "--dry-run", "--json"});
  ASSERT_EQ(dry.exit_code, 0) << dry.errors;
  const json warning = json::parse(dry.text)["warnings"].at(0);
  EXPECT_EQ(warning.get<std::string>().find("A, B: the bank is "), 0U) << warning;
  EXPECT_NE(dry.errors.find("warning: A, B: "), std::string::npos) << dry.errors;
  const json estimate = json::parse(dry.text)["estimate"];
  EXPECT_EQ(estimate["runs_at_least"], 32);
  EXPECT_EQ(estimate["runs_at_most"], 32 * 2 * 4);
  EXPECT_FALSE(fs::exists(out()));
}

TEST_F(HindcastOfBanks, FaultsAreListedWithTheirPointers) {
  json bad = hindcast();
  bad["events"][0]["observed"]["retrogression_m"] = {{"value", 0}, {"sd_ln", 0.1}};
  bad["events"][1]["case_file"] = "bank.json";
  const Output refused =
      run_leda({"hindcast", file("hindcast.json", bad), "--out", out().string()});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.errors.find("/events/0/observed/retrogression_m/value"), std::string::npos)
      << refused.errors;
  EXPECT_NE(refused.errors.find("/events/1/case_file"), std::string::npos) << refused.errors;
}

}  // namespace
}  // namespace leda::tests
