#include <gtest/gtest.h>

#include <cmath>

#include "db/store.hpp"
#include "tests/db/samples.hpp"

namespace leda::db {
namespace {

using samples::layout;
using samples::ScratchFolder;

class SectionStore : public ::testing::Test {
 protected:
  SectionStore() {
    store.add_job(samples::job());
    store.set_sections("job-1", layout(2));
  }
  SectionRecord first() { return store.section("job-1", "S1").value(); }
  std::string last_outcome() { return store.runs(first().id).back().outcome; }

  ScratchFolder folder;
  Store store{folder / "leda.sqlite"};
};

TEST_F(SectionStore, ASectionComesBackWhole) {
  const SectionRecord s = samples::section("S1", 0);
  const SectionRecord back = first();
  EXPECT_GT(back.id, 0);
  EXPECT_EQ(back.job, "job-1");
  EXPECT_EQ(back.ordinal, 0);
  EXPECT_EQ(back.line, s.line);
  EXPECT_EQ(back.order, s.order);
  EXPECT_EQ(back.trace, s.trace);
  EXPECT_EQ(back.ground, s.ground);
  EXPECT_EQ(back.crest, s.crest);
  EXPECT_EQ(back.toe, s.toe);
  EXPECT_EQ(back.state, SectionState::waiting);
  EXPECT_EQ(back.screening, s.screening);
  EXPECT_EQ(back.warnings, s.warnings);
  EXPECT_EQ(back.run, "");
  EXPECT_EQ(back.attempts, 0);
  EXPECT_FALSE(back.result.has_value());
  EXPECT_FALSE(back.placed.has_value());
  EXPECT_EQ(store.section(back.id)->name, "S1");
  EXPECT_FALSE(store.section("job-1", "S3").has_value());
  EXPECT_FALSE(store.section("job-2", "S1").has_value());
}

TEST_F(SectionStore, ALeftOutSectionKeepsItsReason) {
  SectionRecord out;
  out.name = "S9";
  out.state = SectionState::left_out;
  out.reason = "nodata between 12 and 20 m";
  out.crest = {std::nan(""), 0};
  store.add_job(samples::job("job-2"));
  store.set_sections("job-2", {out});
  const auto back = store.section("job-2", "S9");
  EXPECT_EQ(back->state, SectionState::left_out);
  EXPECT_EQ(back->reason, out.reason);
  EXPECT_TRUE(back->ground.empty());
  EXPECT_EQ(back->screening, "");
  EXPECT_TRUE(std::isnan(back->crest.x));
}

TEST_F(SectionStore, ALayoutThatStandsIsKept) {
  const std::int64_t id = first().id;
  store.start_run(id, "run-1");
  store.take_in(id, "run-1", samples::result(), samples::placed(first()), "{}");
  EXPECT_FALSE(store.set_sections("job-1", layout(5)));
  const auto sections = store.sections("job-1");
  ASSERT_EQ(sections.size(), 2U);
  EXPECT_EQ(sections[0].id, id);
  EXPECT_EQ(sections[0].state, SectionState::finished);
  EXPECT_TRUE(sections[0].result.has_value());
}

TEST_F(SectionStore, ALayoutWithAFaultLeavesNothing) {
  store.add_job(samples::job("job-2"));
  auto twice = layout(3);
  twice[2].name = "S1";
  EXPECT_THROW(store.set_sections("job-2", twice), StoreConflict);
  EXPECT_TRUE(store.sections("job-2").empty());
  EXPECT_TRUE(store.set_sections("job-2", layout(3)));
  EXPECT_THROW(store.set_sections("no such job", layout(1)), StoreError);
}

TEST_F(SectionStore, SectionsComeInTheirOrder) {
  store.add_job(samples::job("job-2"));
  auto turned = layout(3);
  std::swap(turned[0], turned[2]);
  store.set_sections("job-2", turned);
  const auto sections = store.sections("job-2");
  ASSERT_EQ(sections.size(), 3U);
  EXPECT_EQ(sections[0].name, "S1");
  EXPECT_EQ(sections[2].name, "S3");
}

TEST_F(SectionStore, MembersHaveTheGroundOfTheirSectionAndAreNoSections) {
  store.add_job(samples::job("job-2"));
  auto rows = layout(2);
  for (int number = 0; number < 3; ++number) {
    SectionRecord member;
    member.ordinal = 2 + number;
    member.name = samples::numbered("S2 member-", number);
    member.member = MemberRecord{rows[1].ordinal, rows[1].name, number, number == 2 ? 1 : 0, false};
    rows.push_back(member);
  }
  store.set_sections("job-2", rows);
  EXPECT_EQ(store.sections("job-2").size(), 2U);
  EXPECT_EQ(store.section_page({.job = "job-2"}).size(), 2U);
  EXPECT_EQ(store.count_sections(PageFilter{.job = "job-2"}), 2);
  EXPECT_TRUE(store.members("job-2", rows[0].ordinal).empty());
  const auto members = store.members("job-2", rows[1].ordinal);
  ASSERT_EQ(members.size(), 3U);
  EXPECT_EQ(members[2].member->section, "S2");
  EXPECT_EQ(members[2].member->repeat, 1);
  const auto line = store.sections_in_line("job-2");
  ASSERT_EQ(line.size(), 5U);
  EXPECT_FALSE(line[1].is_member);
  EXPECT_TRUE(line[2].is_member);
  const auto whole = store.section(members[0].id);
  EXPECT_EQ(whole->ground, rows[1].ground);
  EXPECT_EQ(whole->trace, rows[1].trace);
  EXPECT_EQ(whole->crest.x, rows[1].crest.x);
  store.start_run(members[0].id, "run-m");
  EXPECT_TRUE(
      store.take_in(members[0].id, "run-m", samples::result(), samples::placed(*whole), "{}"));
  EXPECT_EQ(store.members("job-2", rows[1].ordinal)[0].state, SectionState::finished);
}

TEST_F(SectionStore, TenThousandSectionsGoInAndComeOut) {
  store.add_job(samples::job("job-2"));
  store.set_sections("job-2", layout(10'000));
  const auto sections = store.sections("job-2");
  ASSERT_EQ(sections.size(), 10'000U);
  EXPECT_EQ(sections[9'999].name, "S10000");
  EXPECT_EQ(sections[9'999].ground, layout(1)[0].ground);
}

TEST_F(SectionStore, ARunIsCountedAndRemembered) {
  EXPECT_TRUE(store.start_run(first().id, "run-1"));
  EXPECT_EQ(first().state, SectionState::running);
  EXPECT_EQ(first().run, "run-1");
  EXPECT_EQ(first().attempts, 1);

  EXPECT_TRUE(store.start_run(first().id, "run-2"));
  EXPECT_EQ(first().attempts, 2);
  const auto runs = store.runs(first().id);
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0].outcome, "interrupted");
  EXPECT_NE(runs[0].finished, "");
  EXPECT_EQ(runs[1].id, "run-2");
  EXPECT_EQ(runs[1].attempt, 2);
  EXPECT_EQ(runs[1].outcome, "");
  EXPECT_EQ(runs[1].finished, "");
}

TEST_F(SectionStore, ARunIdStandsOnceAndARefusedOneChangesNothing) {
  store.start_run(first().id, "run-1");
  const auto second = store.section("job-1", "S2");
  EXPECT_THROW(store.start_run(second->id, "run-1"), StoreConflict);
  EXPECT_EQ(store.section("job-1", "S2")->state, SectionState::waiting);
  EXPECT_EQ(first().run, "run-1");
  EXPECT_THROW(store.start_run(4711, "run-2"), StoreError);
  EXPECT_THROW(store.set_section_state(4711, SectionState::failed, ""), StoreError);
}

TEST_F(SectionStore, StatesCloseTheTryUnderWay) {
  store.start_run(first().id, "run-1");
  store.set_section_state(first().id, SectionState::waiting, "the worker was killed");
  EXPECT_EQ(last_outcome(), "failed");
  EXPECT_EQ(store.runs(first().id).back().reason, "the worker was killed");
  store.start_run(first().id, "run-2");
  store.set_section_state(first().id, SectionState::waiting, "");
  EXPECT_EQ(last_outcome(), "interrupted");
  store.start_run(first().id, "run-3");
  store.set_section_state(first().id, SectionState::failed, "exit code 2");
  EXPECT_EQ(last_outcome(), "failed");
  EXPECT_EQ(first().reason, "exit code 2");
  store.start_run(first().id, "run-4");
  EXPECT_EQ(first().reason, "");
  store.set_section_state(first().id, SectionState::dismissed, "by the user");
  EXPECT_EQ(last_outcome(), "dismissed");
}

TEST_F(SectionStore, ScreeningIsKeptWithTheSection) {
  store.set_screening(first().id, R"({"decision":"stable"})");
  EXPECT_EQ(first().screening, R"({"decision":"stable"})");
}

TEST_F(SectionStore, ADismissedSectionStaysSo) {
  store.set_section_state(first().id, SectionState::dismissed, "by the user");
  EXPECT_FALSE(store.start_run(first().id, "run-1"));
  for (const SectionState late :
       {SectionState::failed, SectionState::waiting, SectionState::stable, SectionState::left_out})
    EXPECT_FALSE(store.set_section_state(first().id, late, "late"));
  EXPECT_EQ(first().state, SectionState::dismissed);
  EXPECT_EQ(first().reason, "by the user");
  EXPECT_EQ(first().attempts, 0);
}

TEST_F(SectionStore, AFinishedSectionKeepsItsStateAndOnlyAResultFinishes) {
  EXPECT_THROW(store.set_section_state(first().id, SectionState::finished, ""), StoreError);
  store.start_run(first().id, "run-1");
  store.take_in(first().id, "run-1", samples::result(), samples::placed(first()), "{}");
  EXPECT_FALSE(store.set_section_state(first().id, SectionState::dismissed, "too late"));
  EXPECT_FALSE(store.start_run(first().id, "run-2"));
  EXPECT_EQ(first().state, SectionState::finished);
  EXPECT_EQ(store.runs(first().id).size(), 1U);
}

TEST_F(SectionStore, WhatWasRunningWaitsAgainAfterARestart) {
  store.add_job(samples::job("job-2"));
  store.set_sections("job-2", layout(1));
  store.start_run(store.section("job-2", "S1")->id, "run-other-job");
  store.start_run(first().id, "run-1");
  EXPECT_TRUE(store.set_section_state(first().id, SectionState::waiting, ""));
  EXPECT_EQ(first().state, SectionState::waiting);
  EXPECT_EQ(first().attempts, 1);
  EXPECT_EQ(last_outcome(), "interrupted");
  EXPECT_EQ(store.section("job-2", "S1")->state, SectionState::running);
}

}  // namespace
}  // namespace leda::db
