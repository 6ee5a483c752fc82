#pragma once
// The two large members of a region request.

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "server/documents/object_reader.hpp"
#include "server/documents/region_request.hpp"

namespace leda::server {

/// A list of named lines and lines to lay sections along, or one of the latter alone.
SectionLayout read_sections(const nlohmann::json& value, const std::string& at,
                            const RegionLimits& limits, FaultList& faults);

struct ReadSoil {
  std::vector<SoilModel> models;
  std::vector<Fault> meaning;  ///< faults of values that were read: layers, materials, base
};

/// One model, or {"models": [...]} with the polygons where each applies.
ReadSoil read_soil(const nlohmann::json& value, const std::string& at, const RegionLimits& limits,
                   FaultList& faults);

}  // namespace leda::server
