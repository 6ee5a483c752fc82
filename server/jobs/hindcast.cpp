#include "server/jobs/hindcast.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "server/documents/hindcast_document.hpp"
#include "server/drawings/hindcast_drawing.hpp"
#include "server/jobs/without_map.hpp"
#include "server/operate/problem.hpp"
#include "solver/section/warnings.hpp"

namespace leda::server {
namespace {

using db::SectionRecord;
using db::SectionState;
using solver::SharedDraws;

HindcastFile parsed_or_problem(const std::string& request, Members members) {
  auto parsed = parse_hindcast_request(request, members);
  if (!parsed) {
    throw Problem(Failure::invalid_request, "the request cannot be understood", parsed.faults);
  }
  return std::move(*parsed.value);
}

/// Sections of one draw of the local inputs: those of a wave come after each other.
std::size_t runs_a_draw(const HindcastFile& file) { return runs_of_draw(file.plan, 0, 0).size(); }

/// A result counts when it is of the case that is drawn now. It is not where an earlier wave was
/// tried again after this one had run: then this one was drawn from other results.
std::optional<SectionResult> result_of(const HindcastFile& file, const SharedDraws& draws,
                                       const solver::HindcastRun& run,
                                       const SectionRecord& section) {
  const bool drawn_from_results = run.member >= file.plan.draws.members;
  if (!section.result || !drawn_from_results) return section.result;
  const auto read = read_case_file(file.case_of(draws, run));
  const bool same = read && case_sha256(*read.value) == section.result->case_sha256;
  return same ? section.result : std::nullopt;
}

/// Rows of the waves drawn, but for draws that were not wanted.
std::vector<HindcastRow> rows_of(const HindcastFile& file, const SharedDraws& draws,
                                 const std::vector<SectionRecord>& sections) {
  std::vector<HindcastRow> rows;
  std::size_t ordinal = 0;
  for (std::size_t wave = 0; wave < draws.waves(); ++wave) {
    for (std::size_t local = 0; local < file.plan.draws.locals; ++local) {
      for (const auto& run : runs_of_draw(file.plan, wave, local)) {
        const SectionRecord& section = sections.at(ordinal++);
        if (section.state == SectionState::left_out) continue;
        rows.push_back(row_of(file, draws, run, result_of(file, draws, run, section)));
      }
    }
  }
  return rows;
}

/// Draws the wave after those drawn, from their results.
/// @return whether there is one
bool draw_next(const HindcastFile& file, SharedDraws& draws,
               const std::vector<SectionRecord>& sections) {
  const auto outcomes = outcomes_of(file, draws, rows_of(file, draws, sections));
  const auto weights = next_wave(file.plan, draws, outcomes);
  if (weights) draws.add_wave(*weights);
  return weights.has_value();
}

class HindcastJob final : public WithoutMap {
 public:
  HindcastJob(HindcastFile file, const db::Store& store)
      : file_(std::move(file)), store_(store), draws_(file_.plan.draws) {
    for (std::size_t wave = 0; wave < file_.plan.waves; ++wave) {
      for (std::size_t local = 0; local < file_.plan.draws.locals; ++local) {
        const auto runs = runs_of_draw(file_.plan, wave, local);
        runs_.insert(runs_.end(), runs.begin(), runs.end());
      }
    }
  }

  std::vector<SectionRecord> plan() const override {
    std::vector<SectionRecord> sections;
    for (const auto& run : runs_) {
      const CaseFile& of = file_.cases[run.slide].of;
      auto record = record_of(of.section);
      record.warnings = warnings_of(of.section, of.settings);
      record.ordinal = static_cast<int>(sections.size());
      record.name = run_name(file_.plan.draws, run);
      sections.push_back(std::move(record));
    }
    return sections;
  }

  std::string case_file(const SectionRecord& section) const override {
    const auto& run = run_of(section);
    if (!is_drawn(section)) throw std::runtime_error("its wave is not drawn yet");
    const auto document = file_.case_of(draws_, run);
    const auto read = read_case_file(document);
    // Members of the first wave were read when the request came.
    if (!read) {
      throw std::runtime_error(read.faults.front().pointer + " " + read.faults.front().message);
    }
    return document.dump(2) + "\n";
  }

  RunSize size(const SectionRecord& section) const override {
    const CaseFile& of = file_.cases[run_of(section).slide].of;
    RunSettings settings = of.settings;
    settings.output = Output{};
    return run_size(of.section, settings);
  }

  bool may_be_spared(const SectionRecord& section) const override {
    return wave_of(section) > 0 || run_of(section).local > 0;
  }

  std::size_t begins_after(std::size_t ordinal) const override {
    return ordinal / runs_a_draw(file_) * runs_a_draw(file_);
  }

  std::string not_needed(const SectionRecord& section) const override {
    if (slid_before(section)) return "not needed: the member slid here in an earlier draw";
    if (is_drawn(section)) return "";
    return "not needed: the waves before say enough, or no member agrees with all slides";
  }

 private:
  const solver::HindcastRun& run_of(const SectionRecord& section) const {
    return runs_.at(static_cast<std::size_t>(section.ordinal));
  }

  std::size_t wave_of(const SectionRecord& section) const {
    return run_of(section).member / file_.plan.draws.members;
  }

  bool slid_before(const SectionRecord& section) const {
    solver::HindcastRun before = run_of(section);
    while (before.local-- > 0) {
      const auto other = store_.section(section.job, run_name(file_.plan.draws, before));
      if (!other || !other->result) continue;
      if (solver::outcome_of(*other->result).slid().value_or(false)) return true;
    }
    return false;
  }

  /// Draws the waves up to a section's, whose earlier ones have ended.
  bool is_drawn(const SectionRecord& section) const {
    const std::size_t wave = wave_of(section);
    while (!was_last_ && draws_.waves() <= wave) {
      was_last_ = !draw_next(file_, draws_, store_.sections(section.job));
    }
    return wave < draws_.waves();
  }

  HindcastFile file_;
  const db::Store& store_;
  std::vector<solver::HindcastRun> runs_;  ///< by ordinal of the section
  // Of the dispatcher's thread alone:
  mutable SharedDraws draws_;
  mutable bool was_last_ = false;
};

}  // namespace

std::unique_ptr<Work> open_hindcast(const std::string& request, const Library& library) {
  return std::make_unique<HindcastJob>(parsed_or_problem(request, Members::checked), library.store);
}

std::string hindcast_results(const db::JobRecord& job, const std::vector<SectionRecord>& sections,
                             std::string_view format) {
  const HindcastFile file = parsed_or_problem(job.request, Members::taken);
  SharedDraws draws(file.plan.draws);
  while (draw_next(file, draws, sections)) {
  }
  const auto rows = rows_of(file, draws, sections);
  const Hindcast hindcast{file, draws, rows,
                          summarize(file.plan, draws, outcomes_of(file, draws, rows))};
  if (format == "csv") return members_csv(hindcast);
  if (format == "svg") return hindcast_svg(hindcast);
  auto document = to_document(hindcast);
  document["date"] = job.finished;
  return document.dump();
}

}  // namespace leda::server
