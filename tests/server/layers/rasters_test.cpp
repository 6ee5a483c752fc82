#include "server/layers/rasters.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "server/http/problem.hpp"
#include "tests/server/temporary_folder.hpp"

namespace leda::server {
namespace {

class RastersTest : public testing::Test {
 protected:
  /// An Arc ASCII grid of a bank, 40 x 40 m.
  std::filesystem::path bank(double height_m) const {
    auto file = folder.path() / "bank.asc";
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
  profiles::DemOptions mtm8{"m", 2950, {}};
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

}  // namespace
}  // namespace leda::server
