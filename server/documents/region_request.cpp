#include "server/documents/region_request.hpp"

#include <algorithm>
#include <utility>

#include "server/documents/execute_options.hpp"
#include "server/documents/json_syntax.hpp"
#include "server/documents/published_schema.hpp"
#include "server/documents/region_readers.hpp"
#include "server/documents/settings_reader.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

/// Over HTTP a DEM is named, never found by path; GDAL would take much as a path, so what could
/// be one is refused here already.
bool could_be_a_path(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text.find_first_of("/\\:<>") != std::string::npos ||
         text.find("..") != std::string::npos || text.starts_with("vsi");
}

std::string read_dem(ObjectReader& reader, DemNaming naming, FaultList& faults) {
  std::string dem = reader.text("dem", naming == DemNaming::path_allowed ? 4096 : 200);
  if (naming == DemNaming::registered_only && could_be_a_path(dem)) {
    faults.add(reader.at("dem"), "is \"" + dem +
                                     "\", must be the id or name of a registered DEM, without / \\ "
                                     ": < > and ..");
  }
  if (naming == DemNaming::path_allowed && (dem.starts_with("/vsi") || dem.starts_with('<'))) {
    faults.add(reader.at("dem"), "is \"" + dem + "\", must be the path of a file");
  }
  return dem;
}

/// @param meaning faults of values that could be read
RegionGround read_ground(ObjectReader& reader, const RegionLimits& limits,
                         std::vector<Fault>& meaning, FaultList& faults) {
  RegionGround ground;
  if (const json* v = reader.require("soil")) {
    ReadSoil soil = read_soil(*v, reader.at("soil"), limits, faults);
    ground.soil = std::move(soil.models);
    meaning = std::move(soil.meaning);
  }
  ground.settings = read_settings(reader, faults);
  if (std::holds_alternative<ExcavationTrigger>(ground.settings.trigger)) {
    faults.add(reader.at("trigger"),
               "is an excavation, whose polygon belongs to one section; a region takes undrained");
  }
  for (Fault& fault : validate_settings(ground.settings)) {
    meaning.push_back({reader.at("") + fault.pointer.substr(1), std::move(fault.message)});
  }
  return ground;
}

/// The members of `inputs` that a member of an ensemble may draw anew: sections are laid out once.
json what_may_be_drawn(const json& inputs) {
  json document = json::object();
  for (const auto& [name, value] : inputs.items()) {
    const bool fixed = name == "name" || name == "dem" || name == "sections" ||
                       name == "screening" || name == "ensemble" || name == "dryRun";
    if (!fixed) document[name] = value;
  }
  return document;
}

/// @param faults of the ensemble itself
std::optional<RegionEnsemble> read_ensemble_of(const json& inputs, const RegionRequest& request,
                                               FaultList& faults) {
  const std::string at = "/inputs/ensemble";
  if (!inputs.is_object() || !inputs.contains("ensemble")) return std::nullopt;
  FaultList list;
  EnsembleRequest asked = read_ensemble(inputs["ensemble"], at, list);
  UncertainDocument document(what_may_be_drawn(inputs), asked.places, at, list);
  auto found = list.take();
  if (found.empty()) found = schema_faults(PublishedSchema::ensemble, inputs["ensemble"], at);
  std::optional<RegionEnsemble> ensemble;
  if (found.empty()) {
    ensemble = RegionEnsemble{
        drawn(std::move(asked), std::move(document), request.settings.resolution, at, faults)};
  }
  for (Fault& fault : found) faults.add(fault.pointer, fault.message);
  return ensemble;
}

/// @param meaning faults of values that could be read
RegionRequest read_inputs(ObjectReader& reader, DemNaming naming, const RegionLimits& limits,
                          std::vector<Fault>& meaning, FaultList& faults) {
  RegionRequest request;
  request.name = reader.text("name");
  request.dem = read_dem(reader, naming, faults);
  if (const json* v = reader.require("sections")) {
    request.layout = read_sections(*v, reader.at("sections"), limits, faults);
  }
  RegionGround ground = read_ground(reader, limits, meaning, faults);
  request.soil = std::move(ground.soil);
  request.settings = std::move(ground.settings);
  if (const json* v = reader.find("screening")) {
    ObjectReader screening(*v, reader.at("screening"), faults);
    request.skip_stable = screening.boolean_or("skip_stable", true);
    screening.refuse_unknown();
  }
  reader.boolean_or("dryRun", false);  // see execute_options_of
  reader.find("ensemble");             // see read_ensemble_of
  reader.refuse_unknown();
  return request;
}

/// Whether an input may have other values in other soil models.
bool draws_by_soil(const Ensemble& ensemble) {
  return std::ranges::any_of(ensemble.asked.plan.inputs, [](const solver::UncertainInput& input) {
    return input.scope == solver::Scope::soil;
  });
}

}  // namespace

Parsed<RegionGround> RegionEnsemble::ground_of(const solver::Place& place,
                                               std::size_t member) const {
  json inputs = document.with(inputs_of(place, member));
  const json::json_pointer models("/soil/models");
  if (inputs.contains(models) && draws_by_soil(*this)) {
    json& list = inputs[models];
    for (std::size_t i = 0; i < list.size(); ++i) {
      const solver::Place of_model{list[i]["name"].get<std::string>(), place.section};
      list[i] = document.with(inputs_of(of_model, member))[models][i];
    }
  }
  FaultList list;
  std::vector<Fault> meaning;
  ObjectReader reader(inputs, "", list);
  Parsed<RegionGround> ground{read_ground(reader, {}, meaning, list), list.take()};
  add_new_faults(ground.faults, std::move(meaning));
  if (!ground.faults.empty()) ground.value.reset();
  return ground;
}

Parsed<RegionRequest> parse_region_request(std::string_view text, DemNaming naming,
                                           const RegionLimits& limits) {
  auto parsed = parse_json(text);
  if (!parsed) return {std::nullopt, std::move(parsed.faults)};
  FaultList list;
  std::vector<Fault> meaning;
  RegionRequest request;
  ObjectReader body(*parsed.value, "", list);
  if (const json* inputs = body.require("inputs")) {
    ObjectReader reader(*inputs, "/inputs", list);
    request = read_inputs(reader, naming, limits, meaning, list);
    request.ensemble = read_ensemble_of(*inputs, request, list);
  }
  read_execute_options(body, list);
  body.refuse_unknown();
  std::vector<Fault> faults = list.take();
  add_new_faults(faults, std::move(meaning));
  if (faults.empty()) faults = schema_faults(PublishedSchema::region_request, *parsed.value);
  if (!faults.empty()) return {std::nullopt, std::move(faults)};
  return {std::move(request), {}};
}

}  // namespace leda::server
