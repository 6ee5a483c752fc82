#include "server/documents/execute_options.hpp"

#include <algorithm>
#include <array>

namespace leda::server {
namespace {

using nlohmann::json;

/// Outputs stand in the answer as JSON, features as GeoJSON. Other forms have f= of the results.
constexpr std::array known_types{"application/json", "application/geo+json"};

void check_format(const json& format, const std::string& at, FaultList& faults) {
  ObjectReader reader(format, at, faults);
  if (const json* type = reader.find("mediaType")) {
    if (std::ranges::none_of(known_types, [&](const char* known) { return *type == known; })) {
      faults.add(reader.at("mediaType"),
                 "must be application/json or application/geo+json; other forms of the results: "
                 "GET /jobs/{jobID}/results?f=");
    }
  }
  reader.refuse_unknown();
}

std::vector<std::string> read_outputs(const json& value, const std::string& at, FaultList& faults) {
  std::vector<std::string> names;
  if (!value.is_object()) {
    faults.add(at, "is " + kind_of(value) + ", must be an object of the outputs wanted");
    return names;
  }
  for (const auto& [name, wanted] : value.items()) {
    const std::string place = at + "/" + pointer_part(name);
    names.push_back(name);
    ObjectReader reader(wanted, place, faults);
    if (const json* mode = reader.find("transmissionMode"); mode && *mode != "value") {
      faults.add(reader.at("transmissionMode"), "must be \"value\": results are sent themselves");
    }
    if (const json* format = reader.find("format")) {
      check_format(*format, reader.at("format"), faults);
    }
    reader.refuse_unknown();
  }
  return names;
}

}  // namespace

ExecuteOptions read_execute_options(ObjectReader& body, FaultList& faults) {
  ExecuteOptions options;
  options.dry_run = body.boolean_or("dryRun", false);
  if (const json* outputs = body.find("outputs")) {
    options.outputs = read_outputs(*outputs, body.at("outputs"), faults);
  }
  if (const json* response = body.find("response")) {
    options.raw = *response == "raw";
    if (!options.raw && *response != "document") {
      faults.add(body.at("response"), "must be \"document\" or \"raw\"");
    }
    if (options.raw && options.outputs.size() != 1) {
      faults.add(body.at("response"),
                 "is \"raw\", which sends one output: name it in outputs, or take \"document\"");
    }
  }
  if (body.find("subscriber")) {
    faults.add(body.at("subscriber"),
               "is not supported: follow the job by GET /jobs/{jobID} or its events");
  }
  return options;
}

ExecuteOptions execute_options_of(const std::string& request) {
  const json document = json::parse(request, nullptr, false);
  if (!document.is_object()) return {};
  FaultList ignored;
  ObjectReader body(document, "", ignored);
  ExecuteOptions options = read_execute_options(body, ignored);
  const json::json_pointer inside("/inputs/dryRun");
  if (document.contains(inside) && document[inside].is_boolean()) {
    options.dry_run = options.dry_run || document[inside].get<bool>();
  }
  return options;
}

json execute_options_schema() {
  const json format = {{"type", "object"},
                       {"additionalProperties", false},
                       {"properties", {{"mediaType", {{"enum", known_types}}}}}};
  const json one_output = {
      {"type", "object"},
      {"additionalProperties", false},
      {"properties", {{"transmissionMode", {{"enum", {"value"}}}}, {"format", format}}}};
  return {{"dryRun",
           {{"description", "check, lay out and estimate; nothing is stored or run"},
            {"type", "boolean"},
            {"default", false}}},
          {"outputs",
           {{"description", "the outputs wanted; all where absent"},
            {"type", "object"},
            {"additionalProperties", one_output}}},
          {"response",
           {{"description", "raw: the one output named in outputs, by itself"},
            {"enum", {"document", "raw"}},
            {"default", "document"}}}};
}

}  // namespace leda::server
