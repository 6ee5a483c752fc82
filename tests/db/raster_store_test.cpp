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
  EXPECT_EQ(back->lowest_m, r.lowest_m);
  EXPECT_EQ(back->highest_m, r.highest_m);
  EXPECT_EQ(back->share_without_data, r.share_without_data);
  EXPECT_EQ(back->cell_ground_x_m, r.cell_ground_x_m);
  EXPECT_EQ(back->cell_ground_y_m, r.cell_ground_y_m);
  EXPECT_EQ(back->undeclared_fill_m, r.undeclared_fill_m);
  EXPECT_EQ(back->warnings, r.warnings);
  EXPECT_EQ(back->removed, "");
}

TEST(RasterStore, WhatIsNotKnownStaysSo) {
  const ScratchFolder folder;
  Store store(folder / "leda.sqlite");
  RasterRecord r = raster();
  r.lowest_m = r.undeclared_fill_m = std::nullopt;
  store.add_raster(r);
  EXPECT_FALSE(store.raster(r.id)->lowest_m);
  EXPECT_FALSE(store.raster(r.id)->undeclared_fill_m);
  EXPECT_EQ(store.raster(r.id)->highest_m, r.highest_m);
}

TEST(RasterStore, ARasterIsRenamedAndRemoved) {
  const ScratchFolder folder;
  Store store(folder / "leda.sqlite");
  store.add_raster(raster("dem-1"));
  RasterRecord other = raster("dem-2");
  other.name = "other";
  store.add_raster(other);
  EXPECT_TRUE(store.rename_raster("dem-1", "hill"));
  EXPECT_EQ(store.raster("hill")->id, "dem-1");
  EXPECT_THROW(store.rename_raster("dem-1", "other"), StoreConflict);
  EXPECT_FALSE(store.rename_raster("dem-3", "nowhere"));

  JobRecord job = samples::job();
  job.raster = "dem-1";
  store.add_job(job);
  EXPECT_FALSE(store.remove_raster("dem-1")) << "an unfinished job stands on it";
  EXPECT_EQ(store.rasters().size(), 2U);
  store.set_job_state(job.id, JobState::successful, "");
  EXPECT_TRUE(store.remove_raster("dem-1"));
  EXPECT_TRUE(store.remove_raster("dem-2"));
  EXPECT_TRUE(store.rasters().empty());
  EXPECT_FALSE(store.raster("hill"));
  EXPECT_FALSE(store.raster("dem-2"));
  ASSERT_TRUE(store.raster("dem-1"));
  EXPECT_NE(store.raster("dem-1")->removed, "");
  EXPECT_FALSE(store.rename_raster("dem-1", "hill"));
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
