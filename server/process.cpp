#include "server/process.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "server/documents/published_schema.hpp"
#include "server/map_region.hpp"
#include "server/resolution_study.hpp"
#include "server/simulate_section.hpp"

namespace leda::server {
namespace {

nlohmann::json description_of(PublishedSchema which) {
  const auto& whole = published_schema(which);
  const auto& inputs = whole["properties"]["inputs"];
  nlohmann::json described;
  for (const auto& [name, schema] : inputs["properties"].items()) {
    const auto& required = inputs["required"];
    const bool wanted = std::find(required.begin(), required.end(), name) != required.end();
    described[name] = {{"title", schema.value("description", name)},
                       {"minOccurs", wanted ? 1 : 0},
                       {"maxOccurs", 1},
                       {"schema", schema}};
  }
  return {{"inputs", described}, {"definitions", whole["definitions"]}};
}

nlohmann::json describe_region() { return description_of(PublishedSchema::region_request); }
nlohmann::json describe_section() { return description_of(PublishedSchema::simulate_request); }
nlohmann::json describe_study() { return description_of(PublishedSchema::study_request); }

constexpr std::array table{
    Process{"map-region", "Map the hazard of a region",
            "Cuts sections from a DEM, simulates them and joins retrogression and runout to "
            "release and runout zones",
            open_region, describe_region},
    Process{"simulate-section", "Simulate one section",
            "Runs one case through the material point method: retrogression and runout",
            open_section, describe_section},
    Process{"resolution-study", "Error against run time",
            "Runs one case over cell sizes, particles per cell and seeds: the error and the run "
            "time of every setting, and the fastest one within a wanted error",
            open_study, describe_study, study_results},
};

}  // namespace

std::span<const Process> processes() { return table; }

const Process* find_process(std::string_view id) {
  for (const Process& process : table) {
    if (process.id == id) return &process;
  }
  return nullptr;
}

}  // namespace leda::server
