#include "server/jobs/without_map.hpp"

#include "solver/section/crest_and_toe.hpp"

namespace leda::server {

PlacedResult WithoutMap::place(const db::SectionRecord& section,
                               const SectionResult& result) const {
  PlacedResult placed;
  placed.section = section.name;
  placed.retrogression_m = result.crest_to_crest_retrogression_m;
  placed.runout_m = result.runout_m;
  placed.warnings = result.warnings;
  placed.made_by = result.case_sha256 + " leda " + result.version;
  return placed;
}

std::vector<Zone> WithoutMap::zones(const std::vector<db::SectionRecord>& /*sections*/) const {
  return {};
}

db::SectionRecord record_of(const Section& section) {
  db::SectionRecord record;
  record.name = section.name;
  record.ground = section.ground;
  if (const auto found = find_crest_and_toe(section.ground)) {
    record.crest = found->crest;
    record.toe = found->toe;
  }
  record.crest = section.crest.value_or(record.crest);
  record.toe = section.toe.value_or(record.toe);
  return record;
}

}  // namespace leda::server
