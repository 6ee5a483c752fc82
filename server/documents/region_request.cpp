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
RegionRequest read_inputs(ObjectReader& reader, DemNaming naming, const RegionLimits& limits,
                          std::vector<Fault>& meaning, FaultList& faults) {
  RegionRequest request;
  request.name = reader.text("name");
  request.dem = read_dem(reader, naming, faults);
  if (const json* v = reader.require("sections")) {
    request.layout = read_sections(*v, reader.at("sections"), limits, faults);
  }
  if (const json* v = reader.require("soil")) {
    ReadSoil soil = read_soil(*v, reader.at("soil"), limits, faults);
    request.soil = std::move(soil.models);
    meaning = std::move(soil.meaning);
  }
  request.settings = read_settings(reader, faults);
  if (std::holds_alternative<ExcavationTrigger>(request.settings.trigger)) {
    faults.add(reader.at("trigger"),
               "is an excavation, whose polygon belongs to one section; a region takes undrained");
  }
  if (const json* v = reader.find("screening")) {
    ObjectReader screening(*v, reader.at("screening"), faults);
    request.skip_stable = screening.boolean_or("skip_stable", true);
    screening.refuse_unknown();
  }
  reader.boolean_or("dryRun", false);  // see execute_options_of
  reader.refuse_unknown();
  for (Fault& fault : validate_settings(request.settings)) {
    meaning.push_back({"/inputs" + fault.pointer, std::move(fault.message)});
  }
  return request;
}

}  // namespace

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
