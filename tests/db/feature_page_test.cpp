// Pages of features over several jobs, boxes and what is covered.

#include <gtest/gtest.h>

#include "db/database.hpp"
#include "db/migrate.hpp"
#include "db/store.hpp"
#include "tests/db/samples.hpp"

namespace leda::db {
namespace {

/// Two jobs on a DEM, the first successful; S1, S2, S3 of each at 1, 2, 3 degrees east.
class FeaturePage : public ::testing::Test {
 protected:
  FeaturePage() {
    store.add_raster(samples::raster());
    for (const std::string id : {"job-1", "job-2"}) {
      JobRecord job = samples::job(id);
      job.raster = samples::raster().id;
      store.add_job(job);
      store.set_sections(id, samples::layout(3));
      std::vector<FeatureBox> boxes;
      for (const auto& section : store.sections(id)) {
        const double degrees = section.ordinal + 1;
        boxes.push_back({section.id, {degrees, 45, degrees + 0.5, 46}});
      }
      store.set_section_boxes(boxes);
    }
    store.set_job_state("job-1", JobState::successful, "");
  }

  static std::vector<std::string> names(const std::vector<SectionRecord>& page) {
    std::vector<std::string> found;
    found.reserve(page.size());
    for (const auto& section : page) found.push_back(section.job + " " + section.name);
    return found;
  }

  static Zone zone(ZoneKind kind, const std::string& section) {
    Zone z;
    z.kind = kind;
    z.area = {{{{0, 0}, {9, 0}, {9, 9}, {0, 0}}, {}}};
    z.sections = {section};
    return z;
  }

  samples::ScratchFolder folder;
  Store store{folder / "leda.sqlite"};
  using Names = std::vector<std::string>;
};

TEST_F(FeaturePage, OnlyJobsThatSucceededAreShownUnlessOneIsNamed) {
  EXPECT_EQ(names(store.section_page({})), (Names{"job-1 S1", "job-1 S2", "job-1 S3"}));
  EXPECT_EQ(store.count_sections(PageFilter{}), 3);
  EXPECT_EQ(store.section_page({.job = "job-2"}).size(), 3U);
  EXPECT_EQ(store.count_sections(PageFilter{.job = "job-3"}), 0);
}

TEST_F(FeaturePage, PagesFollowEachOther) {
  EXPECT_EQ(names(store.section_page({.limit = 2})), (Names{"job-1 S1", "job-1 S2"}));
  const auto second = store.section("job-1", "S2")->id, third = store.section("job-1", "S3")->id;
  for (const char* job : {"", "job-1"}) {
    EXPECT_EQ(names(store.section_page({.job = job, .limit = 2, .after = second})),
              (Names{"job-1 S3"}));
    EXPECT_TRUE(store.section_page({.job = job, .limit = 2, .after = third}).empty());
  }
  EXPECT_EQ(names(store.section_page({.box = MapBox{0, 0, 9, 90}, .after = second})),
            (Names{"job-1 S3"}));
  EXPECT_EQ(store.count_sections(PageFilter{.after = second}), 3) << "of all pages together";
}

TEST_F(FeaturePage, TheTreeForgetsWhatIsRemovedAndMovesWhatMoved) {
  const auto in = [&](double west, double east) {
    return names(store.section_page({.box = MapBox{west, 40, east, 50}}));
  };
  const auto id = store.section("job-1", "S1")->id;
  store.set_section_boxes({{id, {20, 45, 21, 46}}});
  EXPECT_EQ(in(20, 22), Names{"job-1 S1"});
  EXPECT_EQ(in(0.5, 1.2), Names{}) << "where it lay before";
  ASSERT_TRUE(store.remove_job("job-1"));
  EXPECT_EQ(in(20, 22), Names{});
  EXPECT_TRUE(store.section_page({}).empty());
}

TEST_F(FeaturePage, ABoxSelectsWhatItTouches) {
  EXPECT_EQ(names(store.section_page({.box = MapBox{1.5, 46, 2, 50}})),
            (Names{"job-1 S1", "job-1 S2"}));
  EXPECT_EQ(store.count_sections(PageFilter{.box = MapBox{1.6, 45, 1.9, 46}}), 0);
  EXPECT_EQ(store.count_sections(PageFilter{.job = "job-2", .box = MapBox{0, 0, 9, 90}}), 3);
}

TEST_F(FeaturePage, ABoxMayCrossTheDateLine) {
  EXPECT_EQ(names(store.section_page({.box = MapBox{3.2, 40, -170, 50}})), (Names{"job-1 S3"}));
}

TEST_F(FeaturePage, AFeatureMayCrossTheDateLineToo) {
  const auto id = store.section("job-1", "S1")->id;
  store.set_section_boxes({{id, {179.5, 45, -179.5, 46}}});
  const auto found = [&](double west, double east) {
    return names(store.section_page({.box = MapBox{west, 40, east, 50}}));
  };
  EXPECT_EQ(found(-10, 1), Names{}) << "its box is not the whole world";
  EXPECT_EQ(found(179.8, 180), Names{"job-1 S1"});
  EXPECT_EQ(found(-180, -179.8), Names{"job-1 S1"});
  EXPECT_EQ(found(170, -170), Names{"job-1 S1"});
  EXPECT_EQ(store.section_coverage().box, (MapBox{-180, 45, 180, 46}));
}

TEST_F(FeaturePage, OneIsFoundByItsId) {
  const auto id = store.section("job-1", "S2")->id;
  EXPECT_EQ(names(store.section_page({.id = id})), (Names{"job-1 S2"}));
  EXPECT_TRUE(store.section_page({.id = store.section("job-2", "S2")->id}).empty());
}

TEST_F(FeaturePage, APageLeavesOutTheGroundAndNothingElse) {
  const auto whole = store.section("job-1", "S1").value();
  ASSERT_FALSE(whole.ground.empty());
  const auto row = store.section_page({.limit = 1}).at(0);
  EXPECT_TRUE(row.ground.empty());
  EXPECT_EQ(row.trace, whole.trace);
  EXPECT_EQ(row.screening, whole.screening);
  ASSERT_TRUE(store.start_run(whole.id, "run-1"));
  ASSERT_TRUE(store.take_in(whole.id, "run-1", samples::result(), samples::placed(whole), "{}"));
  const auto with_result = store.section_page({.limit = 1}).at(0);
  ASSERT_TRUE(with_result.result.has_value());
  EXPECT_TRUE(with_result.result->profile_after.empty());
  EXPECT_EQ(with_result.result->version, samples::result().version);
  EXPECT_EQ(with_result.placed->made_by, samples::placed(whole).made_by);
}

TEST_F(FeaturePage, ZonesNameTheVersionThatMadeThem) {
  const auto section = store.section("job-1", "S1").value();
  store.start_run(section.id, "run-1");
  store.take_in(section.id, "run-1", samples::result(), samples::placed(section), "{}");
  store.set_zones("job-1", {zone(ZoneKind::release, "S1"), zone(ZoneKind::runout, "S1"),
                            zone(ZoneKind::runout, "S2")});
  const auto zones = store.zone_page(ZoneLayer::runout, {});
  ASSERT_EQ(zones.size(), 2U);
  EXPECT_EQ(zones[0].version, samples::result().version);
  EXPECT_EQ(zones[1].version, "");
  EXPECT_EQ(store.count_zones(ZoneLayer::release, {}), 1);
}

TEST_F(FeaturePage, CoverageIsTheBoxOfAllAndTheirSystems) {
  const Coverage coverage = store.section_coverage();
  EXPECT_EQ(coverage.features, 3);
  ASSERT_TRUE(coverage.box.has_value());
  EXPECT_EQ(*coverage.box, (MapBox{1, 45, 3.5, 46}));
  EXPECT_EQ(coverage.epsg, std::vector<int>{2950});
  EXPECT_EQ(store.zone_coverage(ZoneLayer::release).features, 0);
  EXPECT_FALSE(store.zone_coverage(ZoneLayer::release).box.has_value());
}

TEST_F(FeaturePage, JobsWithoutBoxesAreFound) {
  EXPECT_TRUE(store.jobs_without_boxes().empty());
  store.set_zones("job-1", {zone(ZoneKind::release, "S1")});
  EXPECT_EQ(store.jobs_without_boxes(), std::vector<std::string>{"job-1"});
  store.set_zone_boxes({{store.zones("job-1").at(0).id, {1, 2, 3, 4}}});
  EXPECT_TRUE(store.jobs_without_boxes().empty());
  store.set_zones("job-1", {});
  EXPECT_EQ(store.zone_coverage(ZoneLayer::release).features, 0);
}

TEST_F(FeaturePage, WaitingSectionsAreCountedOverAllJobs) {
  EXPECT_EQ(store.count_sections(SectionState::waiting), 6);
  store.start_run(store.section("job-1", "S1")->id, "run-1");
  EXPECT_EQ(store.count_sections(SectionState::waiting), 5);
  EXPECT_EQ(store.count_sections(SectionState::running), 1);
}

}  // namespace
}  // namespace leda::db
