#include "server/run/run_folder.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "db/result_file.hpp"
#include "server/documents/case_file.hpp"
#include "server/documents/result_document.hpp"
#include "server/operate/version.hpp"
#include "server/run/run_checkpoint.hpp"
#include "tests/server/documents/read_data.hpp"

namespace leda::server {
namespace {

namespace fs = std::filesystem;

class RunFolder : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder =
        fs::temp_directory_path() / ("leda-run-" + std::to_string(getpid()) + "-" + info->name());
    fs::remove_all(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  std::string read(const char* name) const {
    std::ifstream in(folder / name);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  fs::path folder;
};

TEST_F(RunFolder, ARunLeavesEverythingAndTheResultLast) {
  const std::string text = test::read_case("small-bank.json");
  int heard = 0;
  RunOptions options;
  options.progress = [&](const solver::Progress& p) {
    ++heard;
    EXPECT_GE(p.fraction, 0);
    EXPECT_LE(p.fraction, 1);
    EXPECT_FALSE(fs::exists(folder / "result.json"));
  };
  const RunOutcome outcome = run_case(text, folder, options);
  ASSERT_EQ(outcome.code, ExitCode::result);
  EXPECT_GT(heard, 0);
  const auto result = parse_result(read("result.json"));
  ASSERT_TRUE(result) << test::text(result.faults);
  EXPECT_EQ(result.value->case_sha256, case_sha256(*parse_case_file(text).value));
  EXPECT_GT(result.value->particles, 0);
  EXPECT_EQ(read("profile_after.csv"), profile_csv(result.value->profile_after));
  const auto progress = nlohmann::json::parse(read("progress.json"));
  EXPECT_TRUE(progress["fraction"].is_number());
  EXPECT_FALSE(progress["stage"].get<std::string>().empty());
  const auto frames = db::read_result_file(folder / "fields.h5");
  ASSERT_GE(frames.size(), 2U);
  EXPECT_EQ(frames.back().x.size(), std::size_t(result.value->particles));
  EXPECT_TRUE(fs::exists(folder / "view.pvd"));
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
  }
}

TEST_F(RunFolder, AnInvalidCaseChangesNothing) {
  const RunOutcome outcome = run_case("{}", folder);
  EXPECT_EQ(outcome.code, ExitCode::invalid);
  EXPECT_EQ(outcome.faults.size(), 6U);
  EXPECT_FALSE(outcome.result);
  EXPECT_FALSE(fs::exists(folder));
}

TEST_F(RunFolder, AnInterruptedRunLeavesNoResultAndRunsAgain) {
  const std::string text = test::read_case("small-bank.json");
  RunOptions options;
  options.interrupted = [] { return true; };
  const RunOutcome outcome = run_case(text, folder, options);
  EXPECT_EQ(outcome.code, ExitCode::interrupted);
  EXPECT_FALSE(outcome.result);
  EXPECT_FALSE(fs::exists(folder / "result.json"));
  EXPECT_FALSE(fs::exists(folder / "fields.h5"));
  EXPECT_EQ(run_case(text, folder).code, ExitCode::result);
  EXPECT_TRUE(fs::exists(folder / "result.json"));
}

// The same command continues from the checkpoint and gives what a whole run gives.
TEST_F(RunFolder, AnInterruptedRunGoesOnWhereItStopped) {
  const std::string text = test::read_case("small-bank.json");
  ASSERT_EQ(run_case(text, folder / "whole", {}).code, ExitCode::result);
  double reached = 0;
  RunOptions options;
  options.progress = [&](const solver::Progress& p) { reached = p.time_s; };
  options.interrupted = [&] { return reached > 0.5; };
  ASSERT_EQ(run_case(text, folder / "parts", options).code, ExitCode::interrupted);
  EXPECT_TRUE(fs::exists(folder / "parts" / "checkpoint.bin"));
  double first_heard = -1;
  options.interrupted = nullptr;
  options.progress = [&](const solver::Progress& p) {
    if (first_heard < 0) first_heard = p.time_s;
  };
  ASSERT_EQ(run_case(text, folder / "parts", options).code, ExitCode::result);
  EXPECT_GT(first_heard, 0.5) << "it began anew";
  EXPECT_FALSE(fs::exists(folder / "parts" / "checkpoint.bin"));
  const auto whole = db::read_result_file(folder / "whole" / "fields.h5");
  const auto parts = db::read_result_file(folder / "parts" / "fields.h5");
  ASSERT_EQ(whole.size(), parts.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_EQ(whole[i].x, parts[i].x);
    EXPECT_EQ(whole[i].plastic_strain, parts[i].plastic_strain);
  }
}

/// Interrupts a run after some simulated time, so that its checkpoint stands.
void interrupt(const std::string& text, const fs::path& folder) {
  double reached = 0;
  RunOptions options;
  options.progress = [&](const solver::Progress& p) { reached = p.time_s; };
  options.interrupted = [&] { return reached > 0.3; };
  ASSERT_EQ(run_case(text, folder, options).code, ExitCode::interrupted);
}

void replace(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

// As a whole run gives them, without what depends on the clock.
nlohmann::json numbers_of(const RunOutcome& outcome) {
  auto document = nlohmann::json::parse(result_text(outcome.result.value()));
  document.erase("run_time_s");
  document.erase("ns_per_particle_step");
  return document;
}

TEST_F(RunFolder, ACheckpointThatCannotBeTrustedIsRefusedWithALine) {
  const std::string text = test::read_case("small-bank.json");
  interrupt(text, folder);
  const std::string good = read("checkpoint.bin"), frames = read("frames.bin");
  const auto whole = numbers_of(run_case(text, folder / "whole"));
  const std::size_t frame_count = db::read_result_file(folder / "whole" / "fields.h5").size();
  // A sound checkpoint with a state that the solver does not know: of another build, say.
  fs::create_directories(folder / "foreign");
  RunCheckpoint foreign(folder / "foreign", case_sha256(*parse_case_file(text).value), version());
  foreign.begin();
  foreign.keep("nonsense", 0);
  const std::string unknown_state = read("foreign/checkpoint.bin");
  for (const std::string& bad : {std::string("nonsense"), good.substr(0, good.size() - 1),
                                 good + "x", std::string(), unknown_state}) {
    replace(folder / "checkpoint.bin", bad);
    replace(folder / "frames.bin", frames);
    std::string said;
    RunOptions options;
    options.say = [&](const std::string& line) { said += line; };
    EXPECT_EQ(numbers_of(run_case(text, folder, options)), whole);
    EXPECT_NE(said.find("refused, the run starts anew"), std::string::npos) << said;
    EXPECT_EQ(db::read_result_file(folder / "fields.h5").size(), frame_count);
  }
}

TEST_F(RunFolder, ACheckpointComputedInAnotherWayIsRefused) {
  const std::string text = test::read_case("small-bank.json");
  interrupt(text, folder);
  std::string said;
  RunOptions options;
  options.precision = Precision::double_precision;
  options.say = [&](const std::string& line) { said += line; };
  const RunOutcome outcome = run_case(text, folder, options);
  EXPECT_NE(said.find(std::string(version()) + " in double precision"), std::string::npos) << said;
  ASSERT_TRUE(outcome.result && outcome.result->engine);
  EXPECT_EQ(outcome.result->engine->precision, Precision::double_precision);
  EXPECT_EQ(outcome.result->version, version());
}

TEST_F(RunFolder, KeepsItsLastCheckpointUntilTheResultIsTakenIn) {
  const std::string text = test::read_case("small-bank.json");
  RunOptions options;
  options.keep_checkpoint = true;
  options.checkpoint_interval_s = 0;
  const auto whole = numbers_of(run_case(text, folder, options));
  EXPECT_TRUE(fs::exists(folder / "checkpoint.bin"));
  const auto fields = db::read_result_file(folder / "fields.h5");
  std::string said;
  bool began_anew = false;
  options.say = [&](const std::string& line) { said += line; };
  options.progress = [&](const solver::Progress& p) { began_anew |= p.time_s < 0.3; };
  EXPECT_EQ(numbers_of(run_case(text, folder, options)), whole);
  EXPECT_NE(said.find("goes on from its checkpoint"), std::string::npos) << said;
  EXPECT_FALSE(began_anew);
  const auto again = db::read_result_file(folder / "fields.h5");
  ASSERT_EQ(again.size(), fields.size());
  EXPECT_EQ(again.back().x, fields.back().x);
}

TEST_F(RunFolder, WhatCannotBeWrittenIsNamed) {
  std::ofstream(folder.string()) << "a file where the folder should be";
  EXPECT_THROW(run_case(test::read_case("small-bank.json"), folder), std::runtime_error);
  EXPECT_THROW(disk::write_whole(folder / "x.json", "{}"), std::runtime_error);
}

}  // namespace
}  // namespace leda::server
