#include <gtest/gtest.h>

#include "db/store.hpp"
#include "tests/db/samples.hpp"

namespace leda::db {
namespace {

using samples::raster;
using samples::ScratchFolder;

TEST(RasterStore, ARasterComesBackWhole) {
  const ScratchFolder folder;
  Store store(folder / "leda.sqlite");
  const RasterRecord r = raster();
  store.add_raster(r);
  const auto back = store.raster(r.id);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->id, r.id);
  EXPECT_EQ(back->name, r.name);
  EXPECT_EQ(back->file, r.file);
  EXPECT_EQ(back->sha256, r.sha256);
  EXPECT_EQ(back->epsg, r.epsg);
  EXPECT_EQ(back->cell_x, r.cell_x);
  EXPECT_EQ(back->cell_y, r.cell_y);
  EXPECT_EQ(back->width, r.width);
  EXPECT_EQ(back->height, r.height);
  EXPECT_EQ(back->box, r.box);
  EXPECT_EQ(back->vertical_unit, r.vertical_unit);
  EXPECT_EQ(back->created, r.created);
}

TEST(RasterStore, TheIdWinsOverTheName) {
  const ScratchFolder folder;
  Store store(folder / "leda.sqlite");
  RasterRecord first = raster("dem-1");
  RasterRecord second = raster("dem-2");
  second.name = "dem-1";
  store.add_raster(first);
  store.add_raster(second);
  EXPECT_EQ(store.raster("dem-1")->id, "dem-1");
  EXPECT_EQ(store.raster("valley")->id, "dem-1");
  EXPECT_FALSE(store.raster("nowhere").has_value());
}

TEST(RasterStore, TheSameIdIsReplacedAndKeepsItsPlace) {
  const ScratchFolder folder;
  Store store(folder / "leda.sqlite");
  store.add_raster(raster("dem-1"));
  RasterRecord other = raster("dem-2");
  other.name = "other";
  store.add_raster(other);
  RasterRecord again = raster("dem-1");
  again.name = "renamed";
  store.add_raster(again);
  const auto all = store.rasters();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].name, "renamed");
  EXPECT_EQ(all[1].name, "other");
}

TEST(RasterStore, ANameStandsOnce) {
  const ScratchFolder folder;
  Store store(folder / "leda.sqlite");
  store.add_raster(raster("dem-1"));
  EXPECT_THROW(store.add_raster(raster("dem-2")), StoreConflict);
  EXPECT_EQ(store.rasters().size(), 1U);
}

TEST(RasterStore, ARasterWithAJobCanBeReplaced) {
  const ScratchFolder folder;
  Store store(folder / "leda.sqlite");
  store.add_raster(raster("dem-1"));
  JobRecord job = samples::job();
  job.raster = "dem-1";
  store.add_job(job);
  store.add_raster(raster("dem-1"));
  EXPECT_EQ(store.job("job-1")->raster, "dem-1");
}

}  // namespace
}  // namespace leda::db
