// leda check from the command line.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace leda {
namespace {

namespace fs = std::filesystem;

class CheckCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        fs::temp_directory_path() / ("leda-check-" + std::to_string(getpid()) + "-" +
                                     testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// @return the exit code; what was said is in said_
  int leda(const std::string& arguments) {
    const std::string line =
        "cd '" + folder_.string() + "' && " + LEDA_PROGRAM + " check " + arguments + " 2>&1";
    FILE* pipe = popen(line.c_str(), "r");
    std::array<char, 4096> part{};
    said_.clear();
    while (const std::size_t n = fread(part.data(), 1, part.size(), pipe))
      said_.append(part.data(), n);
    return WEXITSTATUS(pclose(pipe));
  }

  fs::path folder_;
  std::string said_;
};

TEST_F(CheckCommand, TheTableStandsAsTextJsonAndCsv) {
  ASSERT_EQ(leda("--case 5-cells --case time-step-1.01 --json out.json --csv out.csv"), 0) << said_;
  EXPECT_NE(said_.find("5-cells"), std::string::npos);
  EXPECT_NE(said_.find("2 cases, 0 with a broken promise"), std::string::npos) << said_;

  const auto document = nlohmann::json::parse(std::ifstream(folder_ / "out.json"));
  EXPECT_TRUE(document.at("kept"));
  ASSERT_EQ(document.at("cases").size(), 2U);
  const auto& ran = document.at("cases")[0];
  EXPECT_EQ(ran.at("name"), "5-cells");
  EXPECT_TRUE(ran.at("finite"));
  EXPECT_GT(ran.at("steps"), 0);
  EXPECT_LT(ran.at("balances").at("mass"), 1e-6);
  const auto& refused = document.at("cases")[1];
  EXPECT_EQ(refused.at("status"), "refused");
  EXPECT_TRUE(refused.at("reason").get<std::string>().starts_with("/time_step_factor"));

  std::ifstream csv(folder_ / "out.csv");
  std::string line;
  std::getline(csv, line);
  EXPECT_TRUE(line.starts_with("name,extreme,status,"));
  std::getline(csv, line);
  EXPECT_TRUE(line.starts_with("5-cells,"));
}

TEST_F(CheckCommand, ACaseBringsTheOneItIsComparedWith) {
  leda("--case poisson-0.3");
  EXPECT_NE(said_.find("poisson-0.45"), std::string::npos) << said_;
  EXPECT_NE(said_.find("2 cases"), std::string::npos) << said_;
}

TEST_F(CheckCommand, AnUnknownCaseIsRefusedWithTheNamesThereAre) {
  EXPECT_EQ(leda("--case nothing"), 2);
  EXPECT_NE(said_.find("vertical-cut-40"), std::string::npos) << said_;
}

}  // namespace
}  // namespace leda
