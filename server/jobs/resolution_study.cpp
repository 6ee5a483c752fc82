#include "server/jobs/resolution_study.hpp"

#include <nlohmann/json.hpp>

#include "server/documents/study_document.hpp"
#include "server/documents/study_setting.hpp"
#include "server/drawings/study_drawing.hpp"
#include "server/jobs/without_map.hpp"
#include "server/operate/problem.hpp"
#include "solver/section/warnings.hpp"

namespace leda::server {
namespace {

StudyFile parsed_or_problem(const std::string& request) {
  auto parsed = parse_study_request(request);
  if (!parsed) {
    throw Problem(Failure::invalid_request, "the request cannot be understood", parsed.faults);
  }
  return std::move(*parsed.value);
}

class ResolutionStudy final : public WithoutMap {
 public:
  explicit ResolutionStudy(StudyFile asked)
      : asked_(std::move(asked)), runs_(solver::study_runs(asked_.question.settings)) {}

  std::vector<db::SectionRecord> plan() const override {
    auto record = record_of(asked_.of.section);
    std::vector<db::SectionRecord> records;
    for (const solver::StudyRun& run : runs_) {
      const CaseFile of = server::case_of(asked_.of, run);
      record.warnings = warnings_of(of.section, of.settings);
      record.name = run_name(asked_.of, run);
      record.ordinal = static_cast<int>(records.size());
      records.push_back(record);
    }
    return records;
  }

  std::string case_file(const db::SectionRecord& section) const override {
    return to_document(case_of(section)).dump(2) + "\n";
  }

  RunSize size(const db::SectionRecord& section) const override {
    const CaseFile run = case_of(section);
    return run_size(run.section, run.settings);
  }

 private:
  CaseFile case_of(const db::SectionRecord& section) const {
    return server::case_of(asked_.of, runs_.at(static_cast<std::size_t>(section.ordinal)));
  }

  StudyFile asked_;
  std::vector<solver::StudyRun> runs_;  ///< by ordinal of the section
};

}  // namespace

std::unique_ptr<Work> open_study(const std::string& request, const Library& /*library*/) {
  return std::make_unique<ResolutionStudy>(parsed_or_problem(request));
}

std::string study_results(const db::JobRecord& job, const std::vector<db::SectionRecord>& sections,
                          std::string_view format) {
  StudyFile asked = parsed_or_problem(job.request);
  const auto planned = solver::study_runs(asked.question.settings);
  std::vector<solver::StudyRun> runs;
  runs.reserve(sections.size());
  for (const auto& section : sections) {
    runs.push_back(planned.at(static_cast<std::size_t>(section.ordinal)));
    runs.back().result = section.result;
    runs.back().reason = section.reason;
  }
  const Study study = conclude(std::move(asked), std::move(runs), job.finished);
  if (format == "csv") return study_csv(study);
  if (format == "svg") return study_svg(study);
  return to_document(study).dump();
}

}  // namespace leda::server
