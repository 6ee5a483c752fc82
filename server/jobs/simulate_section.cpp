#include "server/jobs/simulate_section.hpp"

#include <nlohmann/json.hpp>

#include "server/documents/simulate_request.hpp"
#include "server/jobs/section_ensemble.hpp"
#include "server/jobs/without_map.hpp"
#include "server/operate/problem.hpp"
#include "solver/section/warnings.hpp"

namespace leda::server {
namespace {

class OneSection final : public WithoutMap {
 public:
  explicit OneSection(CaseFile of) : case_(std::move(of)) {}

  std::vector<db::SectionRecord> plan() const override {
    auto record = record_of(case_.section);
    record.warnings = warnings_of(case_.section, case_.settings);
    return {record};
  }

  std::string case_file(const db::SectionRecord& /*section*/) const override {
    return to_document(case_).dump(2) + "\n";
  }

  RunSize size(const db::SectionRecord& /*section*/) const override {
    return run_size(case_.section, case_.settings);
  }

 private:
  CaseFile case_;
};

}  // namespace

std::unique_ptr<Work> open_section(const std::string& request, const Library& library) {
  auto parsed = parse_simulate_request(request);
  if (!parsed) {
    throw Problem(Failure::invalid_request, "the request cannot be understood", parsed.faults);
  }
  if (parsed.value->ensemble) {
    return open_section_ensemble(std::move(*parsed.value->ensemble), library.store);
  }
  return std::make_unique<OneSection>(std::move(parsed.value->of));
}

}  // namespace leda::server
