#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>

#include "db/store.hpp"
#include "tests/db/samples.hpp"

namespace leda::db {
namespace {

using samples::result;
using samples::ScratchFolder;

class ResultStore : public ::testing::Test {
 protected:
  ResultStore() {
    store.add_job(samples::job());
    store.set_sections("job-1", samples::layout(2));
    id = first().id;
    store.start_run(id, "run-1");
  }
  SectionRecord first() { return store.section("job-1", "S1").value(); }
  bool take_in(const std::string& run, const SectionResult& r) {
    return store.take_in(id, run, r, samples::placed(first()), R"({"status": "as sent"})");
  }

  ScratchFolder folder;
  Store store{folder / "leda.sqlite"};
  std::int64_t id = 0;
};

TEST_F(ResultStore, AResultComesBackWhole) {
  const SectionResult r = result();
  ASSERT_TRUE(take_in("run-1", r));
  const SectionRecord section = first();
  EXPECT_EQ(section.state, SectionState::finished);
  ASSERT_TRUE(section.result.has_value());
  const SectionResult& back = *section.result;
  EXPECT_EQ(back.status, r.status);
  EXPECT_EQ(back.reason, r.reason);
  EXPECT_EQ(back.crest_to_crest_retrogression_m, r.crest_to_crest_retrogression_m);
  EXPECT_EQ(back.runout_m, r.runout_m);
  EXPECT_EQ(back.runout_from_crest_m, r.runout_from_crest_m);
  EXPECT_EQ(back.retrogression_is, r.retrogression_is);
  EXPECT_EQ(back.runout_is, r.runout_is);
  EXPECT_EQ(back.crest, r.crest);
  EXPECT_EQ(back.toe, r.toe);
  EXPECT_EQ(back.backscarp, r.backscarp);
  EXPECT_EQ(back.front, r.front);
  EXPECT_EQ(back.trigger_used, r.trigger_used);
  EXPECT_EQ(back.slides, r.slides);
  EXPECT_EQ(back.rate_from_s, r.rate_from_s);
  EXPECT_EQ(back.simulated_s, r.simulated_s);
  EXPECT_EQ(back.run_time_s, r.run_time_s);
  EXPECT_EQ(back.steps, r.steps);
  EXPECT_EQ(back.particles, r.particles);
  EXPECT_EQ(back.ns_per_particle_step, r.ns_per_particle_step);
  EXPECT_EQ(back.balances.mass, r.balances.mass);
  EXPECT_EQ(back.balances.momentum, r.balances.momentum);
  EXPECT_EQ(back.balances.energy, r.balances.energy);
  EXPECT_EQ(back.numerical_dissipation, r.numerical_dissipation);
  EXPECT_EQ(back.profile_after, r.profile_after);
  EXPECT_EQ(back.warnings, r.warnings);
  EXPECT_EQ(back.case_sha256, r.case_sha256);
  EXPECT_EQ(back.version, r.version);
  EXPECT_EQ(back.engine, r.engine);
  EXPECT_EQ(store.result_document(id), R"({"status": "as sent"})");
}

TEST_F(ResultStore, ThePlaceOnTheMapComesBackWhole) {
  take_in("run-1", result());
  const PlacedResult p = samples::placed(first());
  ASSERT_TRUE(first().placed.has_value());
  const PlacedResult back = *first().placed;
  EXPECT_EQ(back.section, p.section);
  EXPECT_EQ(back.line, p.line);
  EXPECT_EQ(back.order, p.order);
  EXPECT_EQ(back.known, p.known);
  EXPECT_EQ(back.moved, p.moved);
  EXPECT_EQ(back.backscarp, p.backscarp);
  EXPECT_EQ(back.crest, p.crest);
  EXPECT_EQ(back.toe, p.toe);
  EXPECT_EQ(back.front, p.front);
  EXPECT_EQ(back.retrogression_m, p.retrogression_m);
  EXPECT_EQ(back.runout_m, p.runout_m);
  EXPECT_EQ(back.retrogression_is, p.retrogression_is);
  EXPECT_EQ(back.runout_is, p.runout_is);
  EXPECT_EQ(back.warnings, p.warnings);
  EXPECT_EQ(back.made_by, p.made_by);
}

TEST_F(ResultStore, NoResultNoDocument) {
  EXPECT_FALSE(store.result_document(id).has_value());
  EXPECT_FALSE(store.result_document(4711).has_value());
}

TEST_F(ResultStore, TakingTheSameRunInAgainChangesNothing) {
  ASSERT_TRUE(take_in("run-1", result()));
  SectionResult other = result();
  other.runout_m = 1;
  EXPECT_FALSE(take_in("run-1", other));
  EXPECT_EQ(first().result->runout_m, 52.4);
  EXPECT_EQ(store.runs(id).size(), 1U);
}

TEST_F(ResultStore, OfTwoRunsTheFirstResultStands) {
  store.start_run(id, "run-2");
  SectionResult late = result();
  late.runout_m = 1;
  ASSERT_TRUE(take_in("run-1", result()));
  EXPECT_FALSE(take_in("run-2", late));
  EXPECT_EQ(first().result->runout_m, 52.4);
  EXPECT_EQ(first().run, "run-1") << "the run whose result stands";
  EXPECT_EQ(store.runs(id)[0].outcome, "result");
  EXPECT_EQ(store.runs(id)[1].outcome, "superseded");
}

TEST_F(ResultStore, ARunThatWasRequeuedCanStillBeTakenIn) {
  store.set_section_state(id, SectionState::waiting, "");
  EXPECT_TRUE(take_in("run-1", result()));
  EXPECT_EQ(first().state, SectionState::finished);
  EXPECT_EQ(store.runs(id)[0].outcome, "result");
}

TEST_F(ResultStore, AnUnstableRunFailsTheSectionAndMayBeTriedAgain) {
  SectionResult unstable = result(RunStatus::unstable);
  unstable.reason = "the energy audit is off by 12 %";
  unstable.balances.energy = std::nan("");
  ASSERT_TRUE(take_in("run-1", unstable));
  EXPECT_EQ(first().state, SectionState::failed);
  EXPECT_EQ(first().reason, unstable.reason);
  EXPECT_EQ(first().result->status, RunStatus::unstable);
  EXPECT_TRUE(std::isnan(first().result->balances.energy));

  ASSERT_TRUE(store.start_run(id, "run-2"));
  EXPECT_FALSE(first().result.has_value()) << "the latest run has none yet";
  ASSERT_TRUE(take_in("run-2", result()));
  EXPECT_EQ(first().state, SectionState::finished);
  EXPECT_EQ(first().result->status, RunStatus::at_rest);
  EXPECT_EQ(store.runs(id)[0].outcome, "unstable");
}

TEST_F(ResultStore, ADismissedSectionTakesNothingIn) {
  store.set_section_state(id, SectionState::dismissed, "by the user");
  EXPECT_FALSE(take_in("run-1", result()));
  EXPECT_EQ(first().state, SectionState::dismissed);
  EXPECT_FALSE(first().result.has_value());
}

TEST_F(ResultStore, WhatIsNoResultOfThisSectionIsRefused) {
  EXPECT_THROW(take_in("run-1", result(RunStatus::interrupted)), StoreError);
  EXPECT_THROW(take_in("no such run", result()), StoreError);
  const auto second = store.section("job-1", "S2");
  store.start_run(second->id, "run-of-S2");
  EXPECT_THROW(take_in("run-of-S2", result()), StoreError);
  EXPECT_FALSE(first().result.has_value());
  EXPECT_EQ(first().state, SectionState::running);
}

TEST_F(ResultStore, ManyTakersBookOneResult) {
  Store other(folder / "leda.sqlite");
  std::atomic<int> taken = 0;
  std::vector<std::thread> threads;
  threads.reserve(8);
  for (int i = 0; i < 8; ++i)
    threads.emplace_back([&, i] {
      Store& mine = i % 2 == 0 ? store : other;
      if (mine.take_in(id, "run-1", result(), samples::placed(samples::section("S1", 0)), "{}"))
        ++taken;
    });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(taken, 1);
  EXPECT_TRUE(first().result.has_value());
}

}  // namespace
}  // namespace leda::db
