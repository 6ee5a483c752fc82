#include "solver/study/study.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace leda::solver {
namespace {

StudyRun run_of(double cell_m, int particles, std::uint64_t seed, double retrogression_m,
                double runout_m, double run_time_s, RunStatus status = RunStatus::at_rest) {
  SectionResult result;
  result.status = status;
  result.crest_to_crest_retrogression_m = retrogression_m;
  result.runout_m = runout_m;
  result.run_time_s = run_time_s;
  return {{cell_m, particles}, seed, result, ""};
}

StudyRun of_step(StudyRun run, double factor) {
  run.setting.time_step_factor = factor;
  return run;
}

/// Fine and slow, coarse and near the reference, coarse and far from it.
StudyQuestion question() {
  StudyQuestion asked;
  asked.settings = {{{0.5, 4}, 2}, {{1, 4}, 2}, {{2, 4}, 2}};
  asked.reference = StudyReference{100, 50, "field"};
  asked.wanted_error = 0.1;
  return asked;
}

std::vector<StudyRun> runs() {
  return {run_of(2, 4, 0, 130, 50, 1),    run_of(2, 4, 1, 120, 50, 1),
          run_of(2, 4, 2, 110, 50, 1),    run_of(1, 4, 0, 104, 49, 10),
          run_of(1, 4, 1, 108, 50, 12),   run_of(1, 4, 2, 112, 51, 14),
          run_of(0.5, 4, 0, 101, 50, 90), run_of(0.5, 4, 1, 102, 50, 100),
          run_of(0.5, 4, 2, 103, 50, 110)};
}

TEST(StudyRuns, GoFromCoarseToFineAndHoldEverySeed) {
  const auto list =
      study_runs({{{0.5, 4, 0.65}, 0}, {{2, 9, 0.65}, 1}, {{2, 4, 0.65}, 2}, {{2, 9, 0.9}, 0}});
  ASSERT_EQ(list.size(), 7U);
  EXPECT_EQ(list[0].setting, (StudySetting{2, 4, 0.65}));
  EXPECT_EQ(list[0].seed, 0U);
  EXPECT_EQ(list[2].seed, 2U);
  EXPECT_EQ(list[3].setting, (StudySetting{2, 9, 0.9}));
  EXPECT_EQ(list[4].setting, (StudySetting{2, 9, 0.65}));
  EXPECT_EQ(list[6].setting.cell_m, 0.5);
}

TEST(StudySettings, TheFirstAxisThatDiffersTellsTheFiner) {
  EXPECT_TRUE(is_finer({0.5, 1, 1}, {1, 16, 0.1}));
  EXPECT_TRUE(is_finer({1, 9, 1}, {1, 4, 0.1}));
  EXPECT_TRUE(is_finer({1, 4, 0.5}, {1, 4, 0.65}));
  EXPECT_FALSE(is_finer({1, 4, 0.65}, {1, 4, 0.5}));
  EXPECT_FALSE(is_finer({1, 4, 0.5}, {1, 4, 0.5}));
}

TEST(StudySettings, ALineHoldsAllAxesButOne) {
  for (std::size_t i = 0; i < study_axes.size(); ++i) {
    StudySetting moved{1, 4, 0.65};
    study_axes[i].set(moved, 16);
    for (std::size_t j = 0; j < study_axes.size(); ++j) {
      EXPECT_EQ(are_in_line({1, 4, 0.65}, moved, study_axes[j]), i == j) << i << " " << j;
    }
  }
}

TEST(Summary, SpreadIsThatOfTheSample) {
  const auto summary = summarize(question(), runs());
  const Spread& coarse = *summary.settings[2].retrogression_m;
  EXPECT_EQ(coarse.count, 3U);
  EXPECT_DOUBLE_EQ(coarse.mean, 120);
  EXPECT_DOUBLE_EQ(*coarse.standard_deviation, 10);
  EXPECT_DOUBLE_EQ(coarse.least, 110);
  EXPECT_DOUBLE_EQ(coarse.most, 130);
}

TEST(Summary, ErrorsAreSignedAndRelativeToTheReference) {
  const auto summary = summarize(question(), runs());
  EXPECT_DOUBLE_EQ(*summary.errors[0].retrogression, 0.3);
  EXPECT_DOUBLE_EQ(*summary.errors[3].runout, -0.02);
  EXPECT_DOUBLE_EQ(*summary.errors[3].of(Measure::both), 0.04);
  EXPECT_DOUBLE_EQ(*summary.errors[3].of(Measure::runout), 0.02);
  EXPECT_NEAR(summary.settings[1].by(Measure::both).error->mean, 0.08, 1e-12);
}

TEST(Summary, NamesTheFastestByMeanAndTheOneThatStaysWithinWithItsSpread) {
  const auto summary = summarize(question(), runs());
  // 1 m: mean error 8 %, spread 4 %: within 10 % by its mean alone.
  EXPECT_EQ(summary.fastest_by(Measure::both).by_mean, 1U);
  EXPECT_EQ(summary.fastest_by(Measure::both).by_mean_and_spread, 0U);
  EXPECT_EQ(summary.fastest_by(Measure::runout).by_mean, 2U);
}

TEST(Summary, CostLeavesOutWhatSlowedARun) {
  auto some = runs();
  for (StudyRun& run : some) run.result->ns_per_particle_step = 100;
  EXPECT_DOUBLE_EQ(*summarize(question(), some).settings[1].cost_s, 12);
  // The same work at a third of the pace, and a run of twice the steps at the full one.
  some[4].result->run_time_s = 36;
  some[4].result->ns_per_particle_step = 300;
  some[5].result->run_time_s = 28;
  const auto summary = summarize(question(), some);
  EXPECT_DOUBLE_EQ(*summary.settings[1].cost_s, (10 + 12 + 28) / 3.0);
  EXPECT_DOUBLE_EQ(summary.settings[1].run_time_s->most, 36);
}

TEST(Summary, FloorPoolsTheSeedsOfAllSettings) {
  const auto summary = summarize(question(), runs());
  // Variances 100, 16, 1 with two degrees of freedom each.
  EXPECT_NEAR(*summary.floor_retrogression, std::sqrt(117.0 / 3) / 100, 1e-12);
}

/// Two cell sizes and two time steps, two runs each, and one run with more particles.
StudyQuestion question_of_steps() {
  StudyQuestion asked;
  asked.settings = {
      {{1, 4, 0.65}, 1}, {{1, 4, 0.9}, 1}, {{2, 4, 0.65}, 1}, {{2, 4, 0.9}, 1}, {{2, 9, 0.9}, 0}};
  return asked;
}

std::vector<StudyRun> runs_of_steps() {
  return {of_step(run_of(2, 9, 0, 170, 70, 1), 0.9),  of_step(run_of(2, 4, 0, 149, 80, 1), 0.9),
          of_step(run_of(2, 4, 1, 151, 80, 1), 0.9),  of_step(run_of(2, 4, 0, 118, 61, 1), 0.65),
          of_step(run_of(2, 4, 1, 122, 63, 1), 0.65), of_step(run_of(1, 4, 0, 104, 60, 1), 0.9),
          of_step(run_of(1, 4, 1, 106, 60, 1), 0.9),  of_step(run_of(1, 4, 0, 100, 60, 1), 0.65),
          of_step(run_of(1, 4, 1, 100, 60, 1), 0.65)};
}

void expect(const std::optional<Dependence>& found, double metres, double mean,
            std::size_t settings) {
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->metres, metres, 1e-12);
  EXPECT_NEAR(*found->share, metres / mean, 1e-12);
  EXPECT_EQ(found->settings, settings);
}

TEST(Summary, DependenceIsTheLargestDifferenceAlongAnAxisWithTheOthersHeld) {
  const auto summary = summarize(question_of_steps(), runs_of_steps());
  // Cells: 105 and 150 m with steps of 0.9, though 100 and 170 m are further apart.
  expect(summary.dependence[0].retrogression, 45, 127.5, 2);
  expect(summary.dependence[0].runout, 20, 70, 2);
  expect(summary.dependence[1].retrogression, 20, 160, 2);
  expect(summary.dependence[1].runout, 10, 75, 2);
  expect(summary.dependence[2].retrogression, 30, 135, 2);
  expect(summary.dependence[2].runout, 18, 71, 2);
  // Of each setting: over the line through it alone.
  expect(summary.settings[0].dependence[0].retrogression, 20, 110, 2);
  expect(summary.settings[0].dependence[2].retrogression, 5, 102.5, 2);
  EXPECT_FALSE(summary.settings[0].dependence[1].retrogression);
  EXPECT_FALSE(summary.settings[4].dependence[2].runout);
}

TEST(Summary, DependenceOnTheSeedPoolsSettingsWithSeveralRuns) {
  const auto summary = summarize(question_of_steps(), runs_of_steps());
  // Variances 0, 2, 8 and 2 with a degree of freedom each, means 100, 105, 120 and 150 m.
  expect(summary.dependence_on_seed.retrogression, std::sqrt(3.0), 118.75, 4);
  EXPECT_DOUBLE_EQ(*summary.floor_retrogression, std::sqrt(3.0) / 100);
}

TEST(Summary, SettingsThatDidNotComeToRestAreInNoDependence) {
  auto some = runs_of_steps();
  some[1].result->status = RunStatus::time_limit;
  const auto summary = summarize(question_of_steps(), some);
  expect(summary.dependence[0].retrogression, 20, 110, 2);
  EXPECT_FALSE(summary.dependence[1].retrogression);
  expect(summary.dependence[2].retrogression, 5, 102.5, 2);
  EXPECT_FALSE(summary.settings[3].dependence[0].retrogression);
  EXPECT_EQ(summary.dependence_on_seed.retrogression->settings, 3U);
}

TEST(Summary, GroundThatNeverMovesDependsOnNothingAndHasNoShare) {
  auto some = runs();
  for (StudyRun& run : some) run.result->crest_to_crest_retrogression_m = 0;
  const auto summary = summarize(question(), some);
  ASSERT_TRUE(summary.dependence[0].retrogression);
  EXPECT_EQ(summary.dependence[0].retrogression->metres, 0);
  EXPECT_FALSE(summary.dependence[0].retrogression->share);
  EXPECT_EQ(summary.dependence[0].retrogression->settings, 3U);
}

TEST(Summary, ScatterIsThatOfTheMeansOfSettingsThatCameToRest) {
  // Means 102, 108 and 120 m.
  EXPECT_NEAR(*summarize(question(), runs()).scatter_retrogression, std::sqrt(84.0) / 100, 1e-12);
  auto some = runs();
  some[0].result->status = RunStatus::time_limit;
  EXPECT_NEAR(*summarize(question(), some).scatter_retrogression, std::sqrt(18.0) / 100, 1e-12);
}

TEST(Summary, ASettingThatDidNotComeToRestIsShownAndNeverNamed) {
  auto some = runs();
  some[4].result->status = RunStatus::time_limit;
  const auto summary = summarize(question(), some);
  EXPECT_EQ(summary.settings[1].not_a_choice, "1 of 3 runs not at rest at their end");
  EXPECT_EQ(summary.settings[1].retrogression_m->count, 3U);
  EXPECT_FALSE(summary.settings[1].by(Measure::both).mean_within);
  EXPECT_EQ(summary.fastest_by(Measure::both).by_mean, 0U);
}

TEST(Summary, ASettingThatReachedTheModelsEdgeIsShownAndNeverNamed) {
  auto some = runs();
  some[4].result->warnings = {"the front reached the model's edge: runout is a lower bound"};
  const auto summary = summarize(question(), some);
  EXPECT_EQ(summary.settings[1].not_a_choice, "1 of 3 runs at the model's edge");
  EXPECT_EQ(summary.settings[1].runout_m->count, 3U);
  EXPECT_FALSE(summary.settings[1].by(Measure::runout).mean_within);
  EXPECT_EQ(summary.fastest_by(Measure::both).by_mean, 0U);
}

TEST(Summary, UnstableAndMissingRunsLeaveNoNumbers) {
  auto some = runs();
  some[0].result->status = RunStatus::unstable;
  some[1].result.reset();
  some[1].reason = "killed";
  const auto summary = summarize(question(), some);
  const auto& coarse = summary.settings[2];
  EXPECT_EQ(coarse.with_result, 1U);
  EXPECT_DOUBLE_EQ(coarse.retrogression_m->mean, 110);
  EXPECT_FALSE(coarse.retrogression_m->standard_deviation);
  EXPECT_EQ(coarse.not_a_choice, "1 of 3 runs without a result, 1 of 3 runs unstable");
  EXPECT_FALSE(summary.errors[0].retrogression);
  EXPECT_FALSE(summary.errors[1].of(Measure::both));
}

TEST(Summary, ASingleRunIsNeverWithinWithItsSpread) {
  StudyQuestion asked = question();
  asked.settings = {{{0.5, 4}, 0}};
  const auto summary = summarize(asked, {run_of(0.5, 4, 0, 100, 50, 90)});
  EXPECT_EQ(summary.fastest_by(Measure::both).by_mean, 0U);
  EXPECT_FALSE(summary.fastest_by(Measure::both).by_mean_and_spread);
  EXPECT_FALSE(summary.floor_retrogression);
}

TEST(Summary, TheFinestSettingIsTheReferenceAndNoChoice) {
  StudyQuestion asked = question();
  asked.reference.reset();
  const auto summary = summarize(asked, runs());
  EXPECT_EQ(summary.reference_index, 0U);
  EXPECT_DOUBLE_EQ(*summary.reference->retrogression_m, 102);
  EXPECT_TRUE(summary.settings[0].is_reference);
  EXPECT_EQ(summary.fastest_by(Measure::both).by_mean, 1U);
}

TEST(Summary, TheFinestReferenceIsOneWhoseRunsAllEnded) {
  StudyQuestion asked = question();
  asked.reference.reset();
  auto some = runs();
  some[7].result->status = RunStatus::left_domain;
  const auto summary = summarize(asked, some);
  EXPECT_EQ(summary.reference_index, 1U);
  for (StudyRun& run : some) run.result->status = RunStatus::time_limit;
  const auto none = summarize(asked, some);
  EXPECT_FALSE(none.reference);
  EXPECT_FALSE(none.settings[0].by(Measure::both).error);
}

TEST(Summary, ADistanceOfZeroInTheFinestRunsIsNotCompared) {
  StudyQuestion asked = question();
  asked.reference.reset();
  auto some = runs();
  for (StudyRun& run : some) run.result->runout_m = 0;
  const auto summary = summarize(asked, some);
  EXPECT_FALSE(summary.reference->runout_m);
  EXPECT_FALSE(summary.errors[0].runout);
  EXPECT_EQ(summary.errors[0].of(Measure::both), summary.errors[0].of(Measure::retrogression));
}

}  // namespace
}  // namespace leda::solver
