#include <gtest/gtest.h>

#include "db/store.hpp"
#include "tests/db/samples.hpp"

namespace leda::db {
namespace {

Zone zone(ZoneKind kind, const std::vector<std::string>& sections) {
  Zone z;
  z.kind = kind;
  z.area = {{{{0, 0}, {9.5, 0}, {9.5, 9}, {0, 0}}, {{{1, 0.5}, {2, 0.5}, {2, 1}, {1, 0.5}}}}};
  z.sections = sections;
  z.largest_distance_m = 103.2;
  z.mean_distance_m = 88.1;
  z.distance_is = Bound::lower_bound;
  z.warnings = {"a neighbour is missing"};
  z.made_by = std::string(64, 'e');
  return z;
}

class ZoneStore : public ::testing::Test {
 protected:
  ZoneStore() {
    store.add_job(samples::job());
    store.set_sections("job-1", samples::layout(3));
  }
  samples::ScratchFolder folder;
  Store store{folder / "leda.sqlite"};
};

TEST_F(ZoneStore, ZonesOfAnEnsembleKeepTheirProbability) {
  Zone likely = zone(ZoneKind::release, {"S1"});
  likely.probability = ZoneProbability{0.05, 64};
  store.set_zones("job-1", {zone(ZoneKind::release, {"S1"}), likely});
  const auto zones = store.zones("job-1");
  ASSERT_EQ(zones.size(), 2U);
  EXPECT_FALSE(zones[0].zone.probability);
  EXPECT_EQ(zones[1].zone.probability->exceedance, 0.05);
  EXPECT_EQ(zones[1].zone.probability->members, 64);
  const PageFilter filter{.job = "job-1"};
  EXPECT_EQ(store.count_zones(ZoneLayer::release, filter), 1);
  EXPECT_EQ(store.count_zones(ZoneLayer::probability, filter), 1);
  ASSERT_EQ(store.zone_page(ZoneLayer::probability, filter).size(), 1U);
  EXPECT_TRUE(store.zone_page(ZoneLayer::probability, filter)[0].zone.probability);
}

TEST_F(ZoneStore, ZonesComeBackWholeAndInOrder) {
  store.set_zones("job-1", {zone(ZoneKind::runout, {"S2", "S1"}), zone(ZoneKind::release, {"S3"})});
  const auto zones = store.zones("job-1");
  ASSERT_EQ(zones.size(), 2U);
  const Zone expected = zone(ZoneKind::runout, {"S2", "S1"});
  EXPECT_EQ(zones[0].job, "job-1");
  EXPECT_EQ(zones[0].zone.kind, ZoneKind::runout);
  EXPECT_EQ(zones[0].zone.sections, expected.sections);
  ASSERT_EQ(zones[0].zone.area.size(), 1U);
  EXPECT_EQ(zones[0].zone.area[0].outer, expected.area[0].outer);
  EXPECT_EQ(zones[0].zone.area[0].holes, expected.area[0].holes);
  EXPECT_EQ(zones[0].zone.largest_distance_m, expected.largest_distance_m);
  EXPECT_EQ(zones[0].zone.mean_distance_m, expected.mean_distance_m);
  EXPECT_EQ(zones[0].zone.distance_is, expected.distance_is);
  EXPECT_EQ(zones[0].zone.warnings, expected.warnings);
  EXPECT_EQ(zones[0].zone.made_by, expected.made_by);
  EXPECT_EQ(zones[1].zone.kind, ZoneKind::release);
  EXPECT_EQ(zones[1].zone.sections, std::vector<std::string>{"S3"});
}

TEST_F(ZoneStore, ZonesAreReplacedNotAdded) {
  store.set_zones("job-1", {zone(ZoneKind::release, {"S1"}), zone(ZoneKind::release, {"S2"})});
  store.set_zones("job-1", {zone(ZoneKind::runout, {"S1"})});
  ASSERT_EQ(store.zones("job-1").size(), 1U);
  EXPECT_EQ(store.zones("job-1")[0].zone.kind, ZoneKind::runout);
  store.set_zones("job-1", {});
  EXPECT_TRUE(store.zones("job-1").empty());
}

TEST_F(ZoneStore, AFaultyZoneLeavesTheOldOnes) {
  store.set_zones("job-1", {zone(ZoneKind::release, {"S1"})});
  EXPECT_THROW(store.set_zones("job-1", {zone(ZoneKind::runout, {"S1"}),
                                         zone(ZoneKind::runout, {"no such section"})}),
               StoreError);
  const auto zones = store.zones("job-1");
  ASSERT_EQ(zones.size(), 1U);
  EXPECT_EQ(zones[0].zone.kind, ZoneKind::release);
}

// It is dismissed while its zones are being made, or just after they were stored.
TEST_F(ZoneStore, AJobThatIsDismissedBeforeItEndedHasNone) {
  store.set_job_state("job-1", JobState::running, "");
  store.set_zones("job-1", {zone(ZoneKind::release, {"S1"})});
  store.dismiss_job("job-1");
  EXPECT_TRUE(store.zones("job-1").empty());
  store.set_zones("job-1", {zone(ZoneKind::release, {"S1"})});
  EXPECT_TRUE(store.zones("job-1").empty());
}

TEST_F(ZoneStore, AJobThatIsDismissedAfterItEndedKeepsThem) {
  store.set_zones("job-1", {zone(ZoneKind::release, {"S1"})});
  store.set_job_state("job-1", JobState::successful, "");
  store.dismiss_job("job-1");
  EXPECT_EQ(store.zones("job-1").size(), 1U);
}

TEST_F(ZoneStore, EveryJobHasItsOwn) {
  store.add_job(samples::job("job-2"));
  store.set_zones("job-1", {zone(ZoneKind::release, {"S1"})});
  EXPECT_TRUE(store.zones("job-2").empty());
}

}  // namespace
}  // namespace leda::db
