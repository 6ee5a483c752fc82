#include "server/jobs/executors/slurm/array_notes.hpp"

#include <gtest/gtest.h>

#include "tests/disk/synced_paths.hpp"
#include "tests/server/temporary_folder.hpp"

namespace leda::server {
namespace {

TEST(ArrayNotes, ANoteIsOnTheDiskBeforeSlurmHearsOfItsArray) {
  const tests::TemporaryFolder folder;
  const ArrayNotes notes(folder.path());
  ArrayNote note;
  note.name = notes.new_name();
  tests::take_synced_paths();
  notes.write(note);
  const auto file = std::filesystem::canonical(folder.path()) / (note.name + ".json");
  EXPECT_TRUE(
      tests::in_order({file.string() + ".part", file.parent_path()}, tests::take_synced_paths()));
  ASSERT_EQ(notes.read().size(), 1U);
  EXPECT_EQ(notes.read()[0].name, note.name);
}

}  // namespace
}  // namespace leda::server
