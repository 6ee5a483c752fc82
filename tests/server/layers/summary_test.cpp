#include "server/layers/summary.hpp"

#include <gtest/gtest.h>

namespace leda::server {
namespace {

using db::SectionState;

JobCounts sections_in(const std::vector<SectionState>& states) {
  JobCounts counts;
  for (const SectionState state : states) counts.sections.add(state);
  return counts;
}

TEST(Summary, ProgressCountsWhatIsDoneAndWhatRuns) {
  const auto sections = sections_in({SectionState::finished, SectionState::left_out,
                                     SectionState::running, SectionState::waiting});
  EXPECT_EQ(progress_percent(sections, 0), 50);
  EXPECT_EQ(progress_percent(sections, 0.5), 62);
  EXPECT_EQ(progress_message(sections), "2 of 4 sections done, 1 running");
}

TEST(Summary, OnlyAFinishedJobIsAtAHundred) {
  EXPECT_EQ(progress_percent(sections_in({SectionState::finished}), 0), 99);
  EXPECT_EQ(progress_percent({}, 0), 0);
}

TEST(Summary, TheFinalMessageNamesEachKind) {
  EXPECT_EQ(final_message(sections_in({SectionState::finished, SectionState::finished})),
            "2 sections: 2 with a result");
  EXPECT_EQ(final_message(sections_in({SectionState::finished, SectionState::stable,
                                       SectionState::left_out, SectionState::failed})),
            "4 sections: 1 with a result, 1 stable without a run, 1 left out, 1 failed");
}

TEST(Summary, MembersAreToldBesideTheirSections) {
  JobCounts counts = sections_in({SectionState::finished, SectionState::running});
  counts.members.add(SectionState::stable);
  counts.members.add(SectionState::left_out);
  counts.members.add(SectionState::running);
  counts.members.add(SectionState::waiting);
  EXPECT_EQ(progress_percent(counts, 0), 50);
  EXPECT_EQ(progress_message(counts), "1 of 2 sections and 2 of 4 members done, 2 running");
  EXPECT_EQ(final_message(counts),
            "2 sections: 1 with a result; 4 members: 0 with a result, 1 stable without a run, 1 "
            "not needed");
}

TEST(Summary, TheStatusIsTheRunsWhereThereIsOne) {
  db::SectionRecord section;
  section.state = SectionState::left_out;
  EXPECT_EQ(status_of(section), db::to_string(SectionState::left_out));
  section.result.emplace().status = RunStatus::at_rest;
  EXPECT_EQ(status_of(section), "at-rest");
}

}  // namespace
}  // namespace leda::server
