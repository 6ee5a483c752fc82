#include "disk/new_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "disk/temporary_file.hpp"
#include "tests/disk/synced_paths.hpp"
#include "tests/server/temporary_folder.hpp"

namespace leda::disk {
namespace {

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(NewFile, StandsUnderItsNameOnlyWhenKept) {
  const tests::TemporaryFolder folder;
  NewFile file(folder.path() / "a.txt");
  write(file.part(), "whole");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.txt"));
  file.keep();
  EXPECT_EQ(read(folder.path() / "a.txt"), "whole");
  EXPECT_FALSE(std::filesystem::exists(file.part()));
}

TEST(NewFile, IsRemovedWhenNotKeptAndLeavesTheOldOne) {
  const tests::TemporaryFolder folder;
  write(folder.path() / "a.txt", "old");
  {
    NewFile file(folder.path() / "a.txt");
    write(file.part(), "half");
  }
  EXPECT_EQ(read(folder.path() / "a.txt"), "old");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.txt.part"));
}

TEST(NewFile, ReplacesTheOldOneWhole) {
  const tests::TemporaryFolder folder;
  write(folder.path() / "a.txt", "old");
  NewFile file(folder.path() / "a.txt");
  write(file.part(), "new");
  file.keep();
  EXPECT_EQ(read(folder.path() / "a.txt"), "new");
}

TEST(NewFile, BytesComeToTheDiskBeforeTheNameAndTheNameToo) {
  const tests::TemporaryFolder folder;
  const auto from = folder.path() / "a", to = folder.path() / "b";
  write(from, "whole");
  tests::take_synced_paths();
  rename_durably(from, to);
  EXPECT_TRUE(tests::in_order({from, folder.path()}, tests::take_synced_paths()));
  EXPECT_EQ(read(to), "whole");
  EXPECT_THROW(rename_durably(from, to), FileError);
}

TEST(TemporaryFile, GoesWithItsScope) {
  const tests::TemporaryFolder folder;
  {
    const TemporaryFile file(folder.path() / "a");
    write(file.path(), "for a while");
    EXPECT_TRUE(std::filesystem::exists(file.path()));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(NewFile, KeepingWhatWasNeverWrittenNamesTheFile) {
  const tests::TemporaryFolder folder;
  NewFile file(folder.path() / "never.txt");
  try {
    file.keep();
    FAIL() << "should have thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("never.txt"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace leda::disk
