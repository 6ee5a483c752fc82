#include "server/layers/rasters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <future>
#include <latch>

#include "server/operate/problem.hpp"
#include "tests/disk/synced_paths.hpp"
#include "tests/server/temporary_folder.hpp"

namespace leda::server {
namespace {

class RastersTest : public testing::Test {
 protected:
  /// An Arc ASCII grid of a bank, 40 x 40 m.
  std::filesystem::path bank(double height_m) const {
    auto file = folder.path() / (std::to_string(height_m) + ".asc");
    std::ofstream out(file);
    out << "ncols 40\nnrows 40\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9999\n";
    for (int row = 0; row < 40; ++row) {
      for (int column = 0; column < 40; ++column) out << (column < 20 ? height_m : 0) << " ";
      out << "\n";
    }
    return file;
  }

  static Failure failure_of(const std::function<void()>& call) {
    try {
      call();
    } catch (const Problem& problem) {
      return problem.failure;
    }
    return Failure::internal;
  }

  tests::TemporaryFolder folder;
  DataFolder data{folder.path() / "data"};
  db::Store store{data.store()};
  RegisterOptions mtm8{.dem = {.vertical_unit = "m", .epsg = 2950, .limits = {}}};
};

TEST_F(RastersTest, ADemIsCopiedIntoTheDataFolder) {
  const auto raster = register_raster(data, store, bank(10), "a bank", mtm8);
  EXPECT_EQ(raster.id, "dem-" + raster.sha256.substr(0, 12));
  EXPECT_EQ(raster.epsg, 2950);
  EXPECT_EQ(raster.width, 40);
  EXPECT_TRUE(std::filesystem::exists(data.root() / raster.file));
  EXPECT_TRUE(std::filesystem::is_empty(data.uploads()));
  ASSERT_TRUE(store.raster("a bank"));
  EXPECT_EQ(store.raster("a bank")->id, raster.id);
}

TEST_F(RastersTest, ADemIsOnTheDiskBeforeItsRow) {
  const std::filesystem::path root = std::filesystem::canonical(data.root());
  tests::take_synced_paths();
  const auto raster = register_raster(data, store, bank(10), "a bank", mtm8);
  const auto synced = tests::take_synced_paths();
  EXPECT_TRUE(std::ranges::any_of(synced, [&](const auto& path) {
    return path.parent_path() == root / "uploads" && path.extension() == ".tif";
  })) << "its bytes";
  EXPECT_TRUE(tests::in_order({root / "rasters", root / "leda.sqlite-wal"}, synced))
      << "its name, then its row";
}

TEST_F(RastersTest, TheSameAgainChangesNothing) {
  const auto first = register_raster(data, store, bank(10), "a", mtm8);
  const auto second = register_raster(data, store, bank(10), "a", mtm8);
  EXPECT_EQ(first.id, second.id);
  EXPECT_EQ(store.rasters().size(), 1U);
}

TEST_F(RastersTest, ANameIsUsedOnceAndADemHasOneName) {
  register_raster(data, store, bank(10), "a", mtm8);
  EXPECT_EQ(failure_of([&] { register_raster(data, store, bank(12), "a", mtm8); }),
            Failure::name_taken);
  EXPECT_EQ(failure_of([&] { register_raster(data, store, bank(10), "b", mtm8); }),
            Failure::name_taken);
  EXPECT_EQ(store.rasters().size(), 1U);
}

TEST_F(RastersTest, WhatIsNoDemIsRefusedAndLeavesNothing) {
  const auto file = folder.path() / "text.tif";
  std::ofstream(file) << "no raster";
  EXPECT_EQ(failure_of([&] { register_raster(data, store, file, "a", mtm8); }),
            Failure::invalid_request);
  EXPECT_TRUE(store.rasters().empty());
  EXPECT_TRUE(std::filesystem::is_empty(data.rasters()));
  EXPECT_TRUE(std::filesystem::is_empty(data.uploads()));
}

TEST_F(RastersTest, WhatTheCellsHoldIsKept) {
  const auto raster = register_raster(data, store, bank(10), "a", mtm8);
  EXPECT_EQ(raster.lowest_m, 0);
  EXPECT_EQ(raster.highest_m, 10);
  EXPECT_EQ(raster.share_without_data, 0);
  ASSERT_TRUE(raster.cell_ground_x_m);
  EXPECT_NEAR(*raster.cell_ground_x_m, 1, 0.002);
  // Half of it is exactly 0, and the ground beside stands 10 m above. That this is exactly 10 is
  // told as well: either may be the fill.
  EXPECT_EQ(raster.undeclared_fill_m, 0);
  ASSERT_EQ(raster.warnings.size(), 2U);
  EXPECT_NE(raster.warnings[0].find("exactly 0 m"), std::string::npos) << raster.warnings[0];
  EXPECT_NE(raster.warnings[1].find("exactly 10 m"), std::string::npos) << raster.warnings[1];
  EXPECT_EQ(store.raster("a")->warnings, raster.warnings);
}

TEST_F(RastersTest, ThatACellIsGroundCanBeSaidLater) {
  const auto first = register_raster(data, store, bank(10), "a", mtm8);
  read_nodata("none", mtm8);
  const auto again = register_raster(data, store, bank(10), "a", mtm8);
  EXPECT_EQ(again.id, first.id);
  EXPECT_FALSE(again.undeclared_fill_m);
  EXPECT_FALSE(store.raster("a")->undeclared_fill_m);
}

TEST_F(RastersTest, APictureDrawnWhileCellsBecameGroundIsNotShown) {
  const auto first = register_raster(data, store, bank(10), "a", mtm8);
  const auto drawn_late = hillshade_file(data, first);
  read_nodata("none", mtm8);
  const auto again = register_raster(data, store, bank(10), "a", mtm8);
  std::ofstream(drawn_late) << "half of it transparent";
  EXPECT_FALSE(std::filesystem::exists(hillshade_file(data, again)));
  remove_raster(data, store, again.id);
  EXPECT_FALSE(std::filesystem::exists(drawn_late));
}

TEST_F(RastersTest, NodataIsANumberOrNone) {
  RegisterOptions options;
  read_nodata("", options);
  EXPECT_FALSE(options.dem.nodata);
  read_nodata("-32768", options);
  EXPECT_EQ(options.dem.nodata, -32768);
  for (const char* text : {"nothing", "1,5", "1 ", "0x10"}) {
    EXPECT_EQ(failure_of([&] { read_nodata(text, options); }), Failure::invalid_parameter) << text;
  }
}

TEST_F(RastersTest, ARasterIsRenamed) {
  const auto a = register_raster(data, store, bank(10), "a", mtm8);
  const auto b = register_raster(data, store, bank(12), "b", mtm8);
  EXPECT_EQ(rename_raster(store, a.id, "c").name, "c");
  EXPECT_EQ(rename_raster(store, a.id, "c").name, "c");
  EXPECT_EQ(failure_of([&] { rename_raster(store, a.id, "b"); }), Failure::name_taken);
  EXPECT_EQ(failure_of([&] { rename_raster(store, a.id, "../b"); }), Failure::invalid_parameter);
  EXPECT_EQ(failure_of([&] { rename_raster(store, "dem-0", "d"); }), Failure::no_such_resource);
}

TEST_F(RastersTest, ARasterIsRemovedUnlessAJobNeedsIt) {
  const auto raster = register_raster(data, store, bank(10), "a", mtm8);
  db::JobRecord job;
  job.id = "job-1";
  job.process = "map-region";
  job.name = "region";
  job.request = "{}";
  job.raster = raster.id;
  store.add_job(job);
  EXPECT_EQ(failure_of([&] { remove_raster(data, store, raster.id); }), Failure::wrong_state);
  EXPECT_TRUE(std::filesystem::exists(data.root() / raster.file));
  store.set_job_state("job-1", db::JobState::successful, "done");
  remove_raster(data, store, "a");
  EXPECT_TRUE(store.rasters().empty());
  EXPECT_FALSE(std::filesystem::exists(data.root() / raster.file));
  EXPECT_EQ(store.raster(raster.id)->epsg, 2950) << "the place of the job's features";
  EXPECT_EQ(failure_of([&] { remove_raster(data, store, raster.id); }), Failure::no_such_resource);
  // Its name is free, and it can come back.
  EXPECT_EQ(register_raster(data, store, bank(12), "a", mtm8).name, "a");
  EXPECT_EQ(register_raster(data, store, bank(10), "again", mtm8).id, raster.id);
  EXPECT_EQ(store.rasters().size(), 2U);
}

TEST(RasterName, NeverReadsLikeAPath) {
  for (const char* name : {"sainte-monique", "AA' (2024)", "Châteauguay", "a.b_c"}) {
    EXPECT_TRUE(is_raster_name(name)) << name;
  }
  for (const char* name : {"", "a/b", "..", "a..b", "c:x", "<VRT>", "/vsicurl/x", "dem-0123", " a",
                           "a\nb", "a\tb", "a\\b"}) {
    EXPECT_FALSE(is_raster_name(name)) << name;
  }
  EXPECT_FALSE(is_raster_name(std::string(101, 'a')));
}

TEST_F(RastersTest, OfTwoRegistrationsOfOneNameAtOnceOneIsToldThatItIsTaken) {
  for (int round = 0; round < 20; ++round) {
    const std::string name = "round " + std::to_string(round);
    const auto low = bank(20 + 2 * round), high = bank(21 + 2 * round);
    std::latch both(2);
    const auto take_in = [&](const std::filesystem::path& file) {
      both.arrive_and_wait();
      try {
        register_raster(data, store, file, name, mtm8);
        return true;
      } catch (const Problem& problem) {
        EXPECT_EQ(problem.failure, Failure::name_taken) << problem.what();
        return false;
      }
    };
    auto other = std::async(std::launch::async, take_in, low);
    const int taken = (take_in(high) ? 1 : 0) + (other.get() ? 1 : 0);
    EXPECT_EQ(taken, 1);
  }
  EXPECT_EQ(store.rasters().size(), 20U);
  const std::filesystem::directory_iterator files(data.rasters());
  EXPECT_EQ(std::distance(begin(files), end(files)), 20) << "no file without a row";
}

}  // namespace
}  // namespace leda::server
