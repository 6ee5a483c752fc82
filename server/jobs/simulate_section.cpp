#include "server/jobs/simulate_section.hpp"

#include <nlohmann/json.hpp>

#include "server/documents/case_file.hpp"
#include "server/operate/problem.hpp"
#include "solver/section/crest_and_toe.hpp"
#include "solver/section/warnings.hpp"

namespace leda::server {
namespace {

class OneSection final : public Work {
 public:
  explicit OneSection(CaseFile of) : case_(std::move(of)) {}

  std::vector<db::SectionRecord> plan() const override {
    const Section& section = case_.section;
    db::SectionRecord record;
    record.name = section.name;
    record.ground = section.ground;
    const auto found = find_crest_and_toe(section.ground);
    if (found) {
      record.crest = found->crest;
      record.toe = found->toe;
    }
    record.crest = section.crest.value_or(record.crest);
    record.toe = section.toe.value_or(record.toe);
    record.warnings = warnings_of(section, case_.settings);
    return {record};
  }

  std::string raster() const override { return ""; }

  std::string case_file(const db::SectionRecord& /*section*/) const override {
    return to_document(case_).dump(2) + "\n";
  }

  RunSize size(const db::SectionRecord& /*section*/) const override {
    return run_size(case_.section, case_.settings);
  }

  /// A section without a trace has no place on the map.
  PlacedResult place(const db::SectionRecord& section, const SectionResult& result) const override {
    PlacedResult placed;
    placed.section = section.name;
    placed.retrogression_m = result.crest_to_crest_retrogression_m;
    placed.runout_m = result.runout_m;
    placed.warnings = result.warnings;
    placed.made_by = result.case_sha256 + " leda " + result.version;
    return placed;
  }

  std::vector<Zone> zones(const std::vector<db::SectionRecord>& /*sections*/) const override {
    return {};
  }

 private:
  CaseFile case_;
};

}  // namespace

std::unique_ptr<Work> open_section(const std::string& request, const Library& /*library*/) {
  auto parsed = parse_simulate_request(request);
  if (!parsed) {
    throw Problem(Failure::invalid_request, "the request cannot be understood", parsed.faults);
  }
  return std::make_unique<OneSection>(std::move(*parsed.value));
}

}  // namespace leda::server
