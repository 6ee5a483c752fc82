#include "server/jobs/section_queue.hpp"

#include <gtest/gtest.h>

namespace leda::server {
namespace {

using db::SectionState;

TEST(SectionQueue, GivesTheFirstThatWaitsAlsoWhereOneBeforeItComesBack) {
  SectionQueue queue({{11, SectionState::left_out},
                      {12, SectionState::waiting},
                      {13, SectionState::waiting},
                      {14, SectionState::finished}});
  EXPECT_EQ(queue.id(1), 12);
  EXPECT_EQ(queue.first_waiting(), 1U);
  queue.set_state(1, SectionState::running);
  EXPECT_EQ(queue.first_waiting(), 2U);
  queue.set_state(2, SectionState::running);
  EXPECT_EQ(queue.first_waiting(), std::nullopt);
  queue.set_state(1, SectionState::waiting);
  EXPECT_EQ(queue.first_waiting(), 1U);
}

TEST(SectionQueue, TellsWhetherOneOfTheFirstRuns) {
  SectionQueue queue(
      {{1, SectionState::finished}, {2, SectionState::waiting}, {3, SectionState::waiting}});
  EXPECT_FALSE(queue.any_running(3));
  queue.set_state(1, SectionState::running);
  EXPECT_TRUE(queue.any_running(2));
  EXPECT_FALSE(queue.any_running(1));
  EXPECT_FALSE(queue.any_running(0));
}

TEST(SectionQueue, CountsItsStates) {
  SectionQueue queue({{1, SectionState::waiting}, {2, SectionState::waiting}});
  queue.set_state(0, SectionState::failed);
  EXPECT_EQ(queue.counts().of(SectionState::waiting), 1U);
  EXPECT_EQ(queue.counts().of(SectionState::failed), 1U);
  EXPECT_EQ(queue.counts().sections.all(), 2U);
  EXPECT_EQ(queue.counts().sections.done(), 1U);
}

TEST(SectionQueue, CountsMembersApart) {
  SectionQueue queue({{1, SectionState::waiting}, {2, SectionState::waiting, true}});
  queue.set_state(1, SectionState::stable);
  EXPECT_EQ(queue.counts().members.of(SectionState::stable), 1U);
  EXPECT_EQ(queue.counts().sections.of(SectionState::waiting), 1U);
  EXPECT_EQ(queue.counts().of(SectionState::waiting), 1U);
}

TEST(SectionQueue, AnEmptyOneHasNothingThatWaits) {
  EXPECT_EQ(SectionQueue().first_waiting(), std::nullopt);
}

}  // namespace
}  // namespace leda::server
