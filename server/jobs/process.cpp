#include "server/jobs/process.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "server/documents/process_ids.hpp"
#include "server/documents/published_schema.hpp"
#include "server/jobs/hindcast.hpp"
#include "server/jobs/map_region.hpp"
#include "server/jobs/resolution_study.hpp"
#include "server/jobs/simulate_section.hpp"

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

nlohmann::json output(const char* title, const char* type) {
  return {{"title", title}, {"schema", {{"type", type}}}};
}

nlohmann::json zones_output(const char* title) {
  nlohmann::json described = output(title, "object");
  described["schema"]["format"] = "geojson-feature-collection";
  return described;
}

nlohmann::json describe_region() {
  auto document = description_of(PublishedSchema::region_request);
  document["outputs"] = {
      {"sections", output("Retrogression, runout and cost a section", "array")},
      {"release_zones", zones_output("Ground that may slide")},
      {"runout_zones", zones_output("Ground that debris may reach")},
      {"probability_zones", zones_output("The same by probability, where there was an ensemble")}};
  return document;
}

nlohmann::json describe_section() {
  auto document = description_of(PublishedSchema::simulate_request);
  document["outputs"] = {{"sections", output("Retrogression, runout and cost", "array")}};
  return document;
}

nlohmann::json describe_study() {
  auto document = description_of(PublishedSchema::study_request);
  document["outputs"] = {
      {"name", output("Name of the study", "string")},
      {"section", output("Name of the section", "string")},
      {"date", output("When it ended", "string")},
      {"machine", output("Where it ran", "string")},
      {"wanted_error", output("Fraction", "number")},
      {"reference", output("What the errors are relative to", "object")},
      {"seed_spread", output("Scatter between seeds", "object")},
      {"setting_scatter", output("Scatter between settings", "object")},
      {"dependence", output("How far the answer depends on each axis and on the seed", "object")},
      {"settings", output("Error and cost of every setting", "array")},
      {"runs", output("Every run", "array")},
      {"fastest_within_wanted_error", output("The cheapest setting that is good enough", "object")},
      {"outcome", output("The same in words", "array")}};
  return document;
}

nlohmann::json describe_hindcast() {
  auto document = description_of(PublishedSchema::hindcast_request);
  document["outputs"] = {
      {"name", output("Name of the hindcast", "string")},
      {"condition", output("What all of it is conditional on", "string")},
      {"date", output("When it ended", "string")},
      {"members", output("Of all waves", "integer")},
      {"waves", output("Run", "integer")},
      {"locals", output("Draws of local inputs", "integer")},
      {"seed", output("Of the draws", "integer")},
      {"confidence", output("Of predictions and intervals", "number")},
      {"discrepancy", output("As asked, and its bias after the slides", "object")},
      {"weights", output("Whether they can be trusted, and why not", "object")},
      {"shared_inputs", output("Before and after the slides, and how far they moved", "array")},
      {"slides", output("Each slide predicted from the others", "array")},
      {"retrogression", output("Coverage with its chance, sharpness and score", "object")},
      {"runout", output("Coverage with its chance, sharpness and score", "object")},
      {"posterior", output("The shared inputs as inputs of an ensemble, with a label", "object")},
      {"core_s", output("Run time", "number")}};
  return document;
}

constexpr std::array table{
    Process{map_region_id, "Map the hazard of a region",
            "Cuts sections from a DEM, simulates them and joins retrogression and runout to "
            "release and runout zones",
            open_region, describe_region},
    Process{simulate_section_id, "Simulate one section",
            "Runs one case through the material point method: retrogression and runout",
            open_section, describe_section},
    Process{resolution_study_id, "Error against run time",
            "Runs one case over cell sizes, particles per cell, time steps and seeds: the error "
            "and the run time of every setting, the fastest one within a wanted error, and how far "
            "the answer depends on each",
            open_study, describe_study, study_results},
    Process{hindcast_id, "What past slides teach",
            "Runs past slides over their uncertain inputs and weighs members by what was observed: "
            "the shared inputs afterwards, each slide predicted from the others, and whether the "
            "weights can be trusted",
            open_hindcast, describe_hindcast, hindcast_results},
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
