#include "db/new_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "tests/db/samples.hpp"

namespace leda::db {
namespace {

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(NewFile, StandsUnderItsNameOnlyWhenKept) {
  const samples::ScratchFolder folder;
  NewFile file(folder / "a.txt");
  write(file.part(), "whole");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
  file.keep();
  EXPECT_EQ(read(folder / "a.txt"), "whole");
  EXPECT_FALSE(std::filesystem::exists(file.part()));
}

TEST(NewFile, IsRemovedWhenNotKeptAndLeavesTheOldOne) {
  const samples::ScratchFolder folder;
  write(folder / "a.txt", "old");
  {
    NewFile file(folder / "a.txt");
    write(file.part(), "half");
  }
  EXPECT_EQ(read(folder / "a.txt"), "old");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt.part"));
}

TEST(NewFile, ReplacesTheOldOneWhole) {
  const samples::ScratchFolder folder;
  write(folder / "a.txt", "old");
  NewFile file(folder / "a.txt");
  write(file.part(), "new");
  file.keep();
  EXPECT_EQ(read(folder / "a.txt"), "new");
}

TEST(NewFile, KeepingWhatWasNeverWrittenNamesTheFile) {
  const samples::ScratchFolder folder;
  NewFile file(folder / "never.txt");
  try {
    file.keep();
    FAIL() << "should have thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("never.txt"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace leda::db
