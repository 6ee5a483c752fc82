#include "server/jobs/hindcast.hpp"

#include <gtest/gtest.h>

#include "server/documents/hindcast_file.hpp"
#include "server/jobs/dry_run.hpp"
#include "server/operate/problem.hpp"
#include "tests/server/run_fixture.hpp"
#include "tests/server/temporary_folder.hpp"

namespace leda::server {
namespace {

using db::SectionState;
using nlohmann::json;

/// Two slides, 16 members, up to 2 waves and 2 draws of local inputs.
std::string request(double seen_m) {
  const json of = json::parse(tests::small_case());
  const json seen{{"retrogression_m", {{"value", seen_m}, {"sd_ln", 0.01}}}};
  const json inputs{{"name", "two banks"},
                    {"events",
                     {{{"name", "A"}, {"case", of}, {"observed", seen}},
                      {{"name", "B"}, {"case", of}, {"observed", seen}}}},
                    {"ensemble",
                     {{"inputs",
                       {{{"name", "su"},
                         {"path", "/materials/*/peak_strength_kPa"},
                         {"apply", "scale"},
                         {"scope", "region"},
                         {"distribution", {{"type", "uniform"}, {"min", 0.5}, {"max", 1.5}}}}}}}},
                    {"discrepancy", {{"sd_ln", 0.02}}},
                    {"members", 16},
                    {"locals", 2},
                    {"waves", 2}};
  return json{{"inputs", inputs}}.dump();
}

constexpr std::size_t a_draw = 32, a_wave = 2 * a_draw;

/// A job of the store with its runs laid out. Retrogression is 100 m times what is shared.
class HindcastOfAJob : public testing::Test {
 protected:
  explicit HindcastOfAJob(double seen_m = 140) {
    job.id = "job";
    job.process = "hindcast";
    job.request = request(seen_m);
    store.add_job(job);
    work = opened();
    store.set_sections(job.id, work->plan());
  }

  std::unique_ptr<Work> opened() const {
    return find_process(job.process)->open(job.request, {data, store});
  }

  double shared_of(const Work& of, std::size_t index) const {
    const json document = json::parse(of.case_file(store.sections(job.id).at(index)));
    const json given = json::parse(tests::small_case());
    const std::string name = given["materials"].begin().key();
    return document["materials"][name]["peak_strength_kPa"].get<double>() /
           given["materials"][name]["peak_strength_kPa"].get<double>();
  }

  /// Sections of one draw of the local inputs end; those that are not needed are left out.
  void end(std::size_t from, double metres = 100) {
    for (std::size_t i = from; i < from + a_draw; ++i) {
      const auto section = store.sections(job.id).at(i);
      if (const auto reason = work->not_needed(section); !reason.empty()) {
        store.set_section_state(section.id, SectionState::left_out, reason);
        continue;
      }
      const std::string run = "run-" + std::to_string(i);
      SectionResult result = tests::made_up_result();
      result.crest_to_crest_retrogression_m = metres * shared_of(*work, i);
      result.case_sha256 = case_sha256(*parse_case_file(work->case_file(section)).value);
      store.start_run(section.id, run);
      store.take_in(section.id, run, result, work->place(section, result), "{}");
    }
  }

  void end_wave(std::size_t from) {
    end(from);
    end(from + a_draw);
  }

  std::string not_needed(std::size_t index) const {
    return work->not_needed(store.sections(job.id).at(index));
  }

  json results() const {
    return json::parse(hindcast_results(job, store.sections(job.id), "json"));
  }

  tests::TemporaryFolder folder;
  DataFolder data{folder.path()};
  db::Store store{data.store()};
  db::JobRecord job;
  std::unique_ptr<Work> work;
};

TEST_F(HindcastOfAJob, HasASectionForEachRunOfEveryWave) {
  const auto sections = store.sections(job.id);
  ASSERT_EQ(sections.size(), 2 * a_wave);
  EXPECT_EQ(sections[0].name, "wave-1-slide-1-member-0");
  EXPECT_EQ(sections[a_draw].name, "wave-1-slide-1-member-0-local-2");
  EXPECT_EQ(sections[a_wave + 1].name, "wave-2-slide-2-member-16");
  EXPECT_EQ(shared_of(*work, 4), shared_of(*work, 5)) << "one draw for both slides";
}

TEST_F(HindcastOfAJob, AWaveWaitsForTheOnesBefore) {
  EXPECT_EQ(work->begins_after(a_draw - 1), 0U);
  EXPECT_EQ(work->begins_after(a_draw), a_draw);
  EXPECT_EQ(work->begins_after(a_wave + 5), a_wave);
}

TEST_F(HindcastOfAJob, AMemberIsDrawnAgainWhereItStood) {
  end(0, 0);
  EXPECT_EQ(not_needed(a_draw + 3), "");
}

TEST_F(HindcastOfAJob, AMemberThatSlidIsNotDrawnAgain) {
  end(0);
  EXPECT_NE(not_needed(a_draw + 3).find("slid here"), std::string::npos);
}

TEST_F(HindcastOfAJob, ALaterWaveIsDrawnAboutWhatAgrees) {
  end_wave(0);
  EXPECT_EQ(not_needed(a_wave), "");
  double mean = 0;
  for (std::size_t i = a_wave; i < a_wave + a_draw; ++i) mean += shared_of(*work, i) / a_draw;
  EXPECT_GT(mean, 1.15) << "the prior has 1";
  const auto taken_up = opened();
  EXPECT_EQ(taken_up->not_needed(store.sections(job.id).at(a_wave)), "");
  EXPECT_EQ(taken_up->case_file(store.sections(job.id).at(a_wave + 3)),
            work->case_file(store.sections(job.id).at(a_wave + 3)))
      << "another server draws the same";
}

TEST_F(HindcastOfAJob, ItsResultsAreTheHindcastOverAllWaves) {
  end_wave(0);
  end_wave(a_wave);
  const json document = results();
  EXPECT_EQ(document["waves"], 2);
  EXPECT_NEAR(document["shared_inputs"][0]["posterior"][1], 1.4, 0.1);
  EXPECT_TRUE(hindcast_results(job, store.sections(job.id), "svg").starts_with("<svg"));
  EXPECT_TRUE(hindcast_results(job, store.sections(job.id), "csv").starts_with("slide,"));
}

TEST_F(HindcastOfAJob, AWaveDrawnFromOtherResultsDoesNotCount) {
  end_wave(0);
  end_wave(a_wave);
  EXPECT_EQ(results()["slides"][0]["runs"].value("no-result", 0), 0);
  // As if runs of the first wave had been tried again and said something else.
  auto sections = store.sections(job.id);
  for (std::size_t i = 0; i < 8; ++i) {
    sections[i].result->crest_to_crest_retrogression_m = 140;
  }
  const json after = json::parse(hindcast_results(job, sections, "json"));
  EXPECT_GE(after["slides"][0]["runs"].value("no-result", 0), 16);
}

class HindcastThatNeedsNoWave : public HindcastOfAJob {
 protected:
  HindcastThatNeedsNoWave() : HindcastOfAJob(100) {}
};

TEST_F(HindcastThatNeedsNoWave, LeavesItOutWhereNoMemberAgrees) {
  end(0, 0);
  end(a_draw, 0);
  EXPECT_NE(not_needed(a_wave).find("not needed"), std::string::npos);
  EXPECT_NE(not_needed(a_wave + a_draw).find("not needed"), std::string::npos);
  EXPECT_FALSE(results()["weights"]["trusted"]);
}

TEST_F(HindcastOfAJob, ADryRunTellsTheLeastAndTheMost) {
  const json estimate = dry_run(*find_process(job.process), *work, work->plan(), store)["estimate"];
  EXPECT_EQ(estimate["runs"], 2 * a_wave);
  EXPECT_NEAR(estimate["core_hours"].get<double>(),
              4 * estimate["core_hours_at_least"].get<double>(), 1e-9);
}

TEST(HindcastRequest, FaultsHaveTheirPointers) {
  json document = json::parse(request(100));
  document["inputs"]["events"][0]["observed"]["retrogression_m"].erase("sd_ln");
  document["inputs"]["waves"] = 9;
  document["speed"] = 1;
  try {
    const tests::TemporaryFolder folder;
    const DataFolder data{folder.path()};
    const db::Store store{data.store()};
    open_hindcast(document.dump(), {data, store});
    FAIL() << "it was taken";
  } catch (const Problem& problem) {
    ASSERT_EQ(problem.faults.size(), 3U);
    EXPECT_EQ(problem.faults[0].pointer, "/inputs/events/0/observed/retrogression_m/sd_ln");
    EXPECT_EQ(problem.faults[1].pointer, "/inputs/waves");
    EXPECT_EQ(problem.faults[2].pointer, "/speed");
  }
}

}  // namespace
}  // namespace leda::server
