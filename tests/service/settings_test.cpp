// The file of settings: every setting of the program is in deploy/leda.toml, and the other way
// round.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "tests/server/temporary_folder.hpp"
#include "tests/service/leda_process.hpp"
#include "tests/service/region_on_a_bank.hpp"

namespace leda::tests {
namespace {

std::string example() {
  std::ifstream in(std::string(LEDA_SOURCE_DIR) + "/deploy/leda.toml");
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The options that the program itself says it has, as the file would name them.
std::set<std::string> settings_of_program() {
  const std::string help = run_leda({"serve", "--help"}).text;
  std::set<std::string> found;
  const std::regex option("(?:^|\\n) +(?:-[a-z],)?--([a-z0-9-]+)");
  for (std::sregex_iterator at(help.begin(), help.end(), option), end; at != end; ++at) {
    std::string name = (*at)[1];
    if (name == "help" || name == "settings") continue;
    std::replace(name.begin(), name.end(), '-', '_');
    found.insert(name);
  }
  return found;
}

/// The settings in the example, also those that are commented out.
std::set<std::string> settings_of_example() {
  std::set<std::string> found;
  std::istringstream lines(example());
  const std::regex setting("(?:# )?([a-z_]+) = .*"), section("\\[([a-z]+)\\].*");
  std::string before;
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, match, section)) before = match[1].str() + "_";
    if (std::regex_match(line, match, setting)) found.insert(before + match[1].str());
  }
  return found;
}

TEST(Settings, OfTheProgramAndOfTheExampleAreTheSame) {
  EXPECT_GE(settings_of_program().size(), 20U);
  EXPECT_EQ(settings_of_program(), settings_of_example());
}

/// Equal as text or as numbers: 5e9 is 5e+09.
bool same_value(const std::string& one, const std::string& other) {
  if (one == other) return true;
  char* end_of_one = nullptr;
  char* end_of_other = nullptr;
  const double a = std::strtod(one.c_str(), &end_of_one);
  const double b = std::strtod(other.c_str(), &end_of_other);
  return *end_of_one == 0 && *end_of_other == 0 && a == b;
}

TEST(Settings, TheValuesInTheExampleAreTheProgramsDefaults) {
  const std::string help = run_leda({"serve", "--help"}).text;
  std::istringstream lines(example());
  const std::regex setting("([a-z_]+) = \"?([^\"]*)\"?"), section("\\[([a-z]+)\\].*");
  std::string before;
  std::smatch match;
  int compared = 0;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, match, section)) before = match[1].str() + "-";
    if (!std::regex_match(line, match, setting) || match[1] == "data") continue;
    std::string name = before + match[1].str();
    const std::string value = match[2];
    std::replace(name.begin(), name.end(), '_', '-');
    const std::regex shown("--" + name + " [^=\n]*=(\\S+)");
    std::smatch of_program;
    ASSERT_TRUE(std::regex_search(help, of_program, shown)) << name << "\n" << help;
    EXPECT_TRUE(same_value(of_program[1], value)) << name << ": " << of_program[1] << ", " << value;
    ++compared;
  }
  EXPECT_GE(compared, 14);
}

class SettingsFile : public testing::Test {
 protected:
  std::string write(const std::string& text) {
    const auto file = folder.path() / "leda.toml";
    std::ofstream(file) << text;
    return file.string();
  }
  TemporaryFolder folder;
};

TEST_F(SettingsFile, TheExampleStartsAServer) {
  std::string text = example();
  // The folder and the port of a machine that others may use.
  text = std::regex_replace(text, std::regex("data = \"[^\"]*\""),
                            "data = \"" + (folder.path() / "nowhere").string() + "\"");
  LedaServer server(folder.path() / "data", {"--settings", write(text)});
  EXPECT_EQ(server.client().Get("/readyz")->status, 200);
  EXPECT_FALSE(exists(folder.path() / "nowhere")) << "the command line wins";
}

TEST_F(SettingsFile, SetsWhatTheCommandLineLeavesOpen) {
  const auto file = write("most_sections = 3\n");
  const std::vector<std::string> more = {"--settings", file};
  LedaServer server(folder.path() / "data", more);
  write_bank(folder.path() / "bank.asc");
  std::ifstream dem(folder.path() / "bank.asc", std::ios::binary);
  server.client().Post(std::string("/rasters") + bank_query,
                       std::string{std::istreambuf_iterator<char>(dem), {}}, "image/tiff");
  const auto answer = server.client().Post("/processes/map-region/execution", bank_region().dump(),
                                           "application/json");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 400);
  EXPECT_NE(answer->body.find("4 sections, more than 3"), std::string::npos) << answer->body;
}

TEST_F(SettingsFile, NamesEveryFaultAtOnce) {
  const auto file = write("most_job = 5\nmost_streams = \"many\"\n[slurm]\nmax_array_size = 0\n");
  const Output refused = run_leda({"serve", "--data", folder.path().string(), "--settings", file});
  EXPECT_EQ(refused.exit_code, 2);
  for (const char* words :
       {"line 1", "most_job", "line 2", "most_streams", "line 4", "slurm_max_array_size"}) {
    EXPECT_NE(refused.errors.find(words), std::string::npos) << words << "\n" << refused.errors;
  }
}

TEST_F(SettingsFile, WhatIsNoTomlIsNamedWithItsLine) {
  const auto file = write("most_jobs = 5\nmost_streams =\n");
  const Output refused = run_leda({"serve", "--data", folder.path().string(), "--settings", file});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.errors.find("line 2"), std::string::npos) << refused.errors;
}

TEST_F(SettingsFile, SlurmSettingsThatCannotWorkAreNamedBeforeAnythingStarts) {
  const auto file = write(
      "executor = \"slurm\"\n[slurm]\nprogram = \"leda\"\noption = [\"rm\"]\n"
      "shared_folder = \"/nowhere\"\n");
  const Output refused = run_leda({"serve", "--data", folder.path().string(), "--settings", file});
  EXPECT_NE(refused.exit_code, 0);
  for (const char* words : {"slurm-program", "slurm-option", "slurm-shared-folder"}) {
    EXPECT_NE(refused.errors.find(words), std::string::npos) << words << "\n" << refused.errors;
  }
}

}  // namespace
}  // namespace leda::tests
