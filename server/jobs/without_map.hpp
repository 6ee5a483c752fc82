#pragma once
// What the processes that take a case file share: their sections have no place on the map.

#include "server/jobs/process.hpp"
#include "solver/section/section.hpp"

namespace leda::server {

class WithoutMap : public Work {
 public:
  std::string raster() const final { return ""; }
  /// Only distances: a section without a trace has no place.
  PlacedResult place(const db::SectionRecord& section, const SectionResult& result) const final;
  std::vector<Zone> zones(const std::vector<db::SectionRecord>& sections) const final;
};

/// The record of a section as it is to be run: name, ground, crest and toe.
db::SectionRecord record_of(const Section& section);

}  // namespace leda::server
