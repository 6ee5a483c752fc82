#include "server/operate/data_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>

#include "tests/server/temporary_folder.hpp"

namespace leda::server {
namespace {

TEST(DataFolder, MakesItsFolders) {
  const tests::TemporaryFolder folder;
  const DataFolder data(folder.path() / "new" / "data");
  for (const auto& part : {data.rasters(), data.runs(), data.exports(), data.uploads()}) {
    EXPECT_TRUE(std::filesystem::is_directory(part)) << part;
  }
}

TEST(DataFolder, SaysWhichFolderCannotBeMade) {
  const tests::TemporaryFolder folder;
  const auto file = folder.path() / "file";
  std::ofstream(file) << "no folder";
  try {
    const DataFolder data(file);
    FAIL() << "a file served as a folder";
  } catch (const DataFolderError& error) {
    EXPECT_NE(std::string(error.what()).find(file.string()), std::string::npos);
  }
}

TEST(DataFolder, ATextForPeopleOutsideDoesNotTellWhereItIs) {
  const tests::TemporaryFolder folder;
  const DataFolder data(folder.path() / "data");
  const std::string root = data.root().string();
  EXPECT_EQ(data.without_root(root + "/runs/a/x: no, see " + data.run("b").string()),
            "runs/a/x: no, see runs/b");
  EXPECT_EQ(data.without_root(root), "");
  EXPECT_EQ(data.without_root("nothing of it"), "nothing of it");
}

TEST(RunnerLock, OneHoldsItAndTheNextMayAfterwards) {
  const tests::TemporaryFolder folder;
  const DataFolder data(folder.path());
  auto first = std::make_unique<RunnerLock>(data);
  EXPECT_THROW(RunnerLock{data}, DataFolderError);
  first.reset();
  EXPECT_NO_THROW(RunnerLock{data});
}

TEST(RandomHex, DiffersEachTime) {
  EXPECT_EQ(random_hex(12).size(), 12U);
  EXPECT_NE(random_hex(12), random_hex(12));
}

}  // namespace
}  // namespace leda::server
