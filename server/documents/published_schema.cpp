#include "server/documents/published_schema.hpp"

#include <algorithm>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "server/documents/embedded_schemas.hpp"
#include "server/documents/execute_options.hpp"
#include "solver/section/fault_list.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using Adapter = valijson::adapters::NlohmannJsonAdapter;
using Context = std::vector<std::string>;

/// A schema's own definitions, and those that all share.
json with_definitions(const char* text) {
  json schema = json::parse(text);
  schema["definitions"].update(json::parse(definitions_schema_text));
  return schema;
}

/// The case schema inside {"inputs": {"case": ..., "ensemble": ...}}.
json simulate_schema() {
  json inner = with_definitions(case_schema_text);
  json outer{{"$schema", inner["$schema"]},
             {"title", "Leda simulate-section request"},
             {"type", "object"},
             {"additionalProperties", false},
             {"required", {"inputs"}},
             {"definitions", inner["definitions"]}};
  inner.erase("$schema");
  inner.erase("definitions");
  outer["properties"]["inputs"] = {
      {"type", "object"},
      {"additionalProperties", false},
      {"required", {"case"}},
      {"properties", {{"case", inner}, {"ensemble", {{"$ref", "#/definitions/ensemble"}}}}}};
  return outer;
}

/// The member "ensemble" by itself.
json ensemble_schema() {
  return {{"$schema", "http://json-schema.org/draft-07/schema#"},
          {"title", "Leda ensemble"},
          {"$ref", "#/definitions/ensemble"},
          {"definitions", json::parse(definitions_schema_text)}};
}

/// A schema with the case schema among its definitions.
json with_case(const char* text) {
  json schema = with_definitions(text);
  json inner = json::parse(case_schema_text);
  inner.erase("$schema");
  schema["definitions"]["case"] = inner;
  return schema;
}

/// With what a request may say beside its inputs.
json with_options(json request) {
  request["properties"].update(execute_options_schema());
  return request;
}

struct Published {
  explicit Published(json document) : text(std::move(document)) {
    valijson::SchemaParser parser;
    parser.populateSchema(Adapter(text), compiled);
  }
  json text;
  valijson::Schema compiled;
};

const Published& published(PublishedSchema which) {
  static const Published case_file(with_definitions(case_schema_text));
  static const Published ensemble(ensemble_schema());
  static const Published region(with_options(with_definitions(region_schema_text)));
  static const Published simulate(with_options(simulate_schema()));
  static const Published study(with_options(with_case(resolution_study_request_schema_text)));
  static const Published hindcast(with_options(with_case(hindcast_request_schema_text)));
  switch (which) {
    case PublishedSchema::case_file:
      return case_file;
    case PublishedSchema::hindcast_request:
      return hindcast;
    case PublishedSchema::ensemble:
      return ensemble;
    case PublishedSchema::region_request:
      return region;
    case PublishedSchema::study_request:
      return study;
    default:
      return simulate;
  }
}

/// valijson writes the way to a value as <root> ["key"] [3].
std::string pointer_of(const Context& context) {
  std::string pointer;
  for (std::size_t i = 1; i < context.size(); ++i) {
    std::string_view part = context[i];
    if (part.starts_with('[') && part.ends_with(']')) part = part.substr(1, part.size() - 2);
    if (part.size() > 1 && part.starts_with('"')) part = part.substr(1, part.size() - 2);
    pointer += '/';
    pointer += pointer_part(part);
  }
  return pointer;
}

bool is_above(const Context& outer, const Context& inner) {
  return outer.size() < inner.size() && std::equal(outer.begin(), outer.end(), inner.begin());
}

}  // namespace

const json& published_schema(PublishedSchema which) { return published(which).text; }

std::vector<Fault> schema_faults(PublishedSchema which, const json& document,
                                 const std::string& at) {
  // Strong types: the text "1" is no number.
  valijson::Validator validator(valijson::Validator::kStrongTypes);
  valijson::ValidationResults results;
  if (validator.validate(published(which).compiled, Adapter(document), &results)) return {};
  // Every fault is told again by each value around it; only the innermost place says something.
  std::vector<Fault> faults;
  for (const auto& error : results) {
    const bool told_inside = std::ranges::any_of(
        results, [&](const auto& other) { return is_above(error.context, other.context); });
    if (told_inside) continue;
    faults.push_back({at + pointer_of(error.context),
                      "does not match the published schema: " + error.description});
  }
  return faults;
}

}  // namespace leda::server
