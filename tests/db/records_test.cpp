#include "db/records.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace leda::db {
namespace {

TEST(Records, EveryJobStateHasAWordOfItsOwnThatLeadsBack) {
  std::set<std::string> words;
  for (const JobState state : {JobState::accepted, JobState::running, JobState::successful,
                               JobState::failed, JobState::dismissed}) {
    words.insert(to_string(state));
    EXPECT_EQ(job_state_from(to_string(state)), state);
  }
  EXPECT_EQ(words,
            (std::set<std::string>{"accepted", "running", "successful", "failed", "dismissed"}));
}

TEST(Records, EverySectionStateHasAWordOfItsOwnThatLeadsBack) {
  std::set<std::string> words;
  for (const SectionState state :
       {SectionState::waiting, SectionState::running, SectionState::finished,
        SectionState::left_out, SectionState::stable, SectionState::failed,
        SectionState::dismissed}) {
    words.insert(to_string(state));
    EXPECT_EQ(section_state_from(to_string(state)), state);
  }
  EXPECT_EQ(words.size(), 7U);
}

TEST(Records, OtherWordsAreNoState) {
  EXPECT_EQ(job_state_from(""), std::nullopt);
  EXPECT_EQ(job_state_from("Accepted"), std::nullopt);
  EXPECT_EQ(section_state_from("left out"), std::nullopt);
}

}  // namespace
}  // namespace leda::db
