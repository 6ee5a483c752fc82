#include "server/documents/openapi_schema.hpp"

#include <array>
#include <utility>

#include "server/documents/embedded_schemas.hpp"
#include "server/documents/published_schema.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

const json& interface_document() {
  static const json document = json::parse(api_schema_text);
  return document;
}

/// Draft-07 states an exclusive bound as a number, OpenAPI 3.0 as a property of the bound.
void exclusive_bound(json& schema, const char* exclusive, const char* bound) {
  const auto found = schema.find(exclusive);
  if (found == schema.end() || !found->is_number()) return;
  schema[bound] = *found;
  schema[exclusive] = true;
}

/// A list of schemas, one an item, does not exist in OpenAPI 3.0: any of them for all items.
json items_of(const json& items) {
  if (!items.is_array()) return to_openapi(items);
  json any = json::array();
  for (const auto& item : items) any.push_back(to_openapi(item));
  return {{"anyOf", any}};
}

json members_of(const json& members) {
  json converted = json::object();
  for (const auto& [name, schema] : members.items()) converted[name] = to_openapi(schema);
  return converted;
}

json referenced(const std::string& reference) {
  const std::string name = reference.substr(reference.rfind('/') + 1);
  return {{"$ref", "#/components/schemas/" + name}};
}

}  // namespace

json to_openapi(const json& schema) {
  if (!schema.is_object()) return schema;
  if (schema.contains("$ref")) return referenced(schema["$ref"].get<std::string>());
  json converted = json::object();
  for (const auto& [key, value] : schema.items()) {
    if (key == "$schema" || key == "definitions") continue;
    if (key == "const") {
      converted["enum"] = json::array({value});
    } else if (key == "properties") {
      converted[key] = members_of(value);
    } else if (key == "items") {
      converted[key] = items_of(value);
    } else if (key == "oneOf" || key == "anyOf" || key == "allOf") {
      converted[key] = json::array();
      for (const auto& part : value) converted[key].push_back(to_openapi(part));
    } else if (key == "not" || key == "additionalProperties") {
      converted[key] = to_openapi(value);
    } else {
      converted[key] = value;
    }
  }
  exclusive_bound(converted, "exclusiveMinimum", "minimum");
  exclusive_bound(converted, "exclusiveMaximum", "maximum");
  return converted;
}

json openapi_schemas() {
  json schemas = interface_document().at("schemas");
  const std::array requests{
      std::pair{"map-region-request", PublishedSchema::region_request},
      std::pair{"simulate-section-request", PublishedSchema::simulate_request},
      std::pair{"resolution-study-request", PublishedSchema::study_request},
      std::pair{"hindcast-request", PublishedSchema::hindcast_request}};
  for (const auto& [name, which] : requests) {
    const json& schema = published_schema(which);
    schemas[name] = to_openapi(schema);
    schemas.update(members_of(schema.at("definitions")));
  }
  return schemas;
}

json openapi_parameters() { return interface_document().at("parameters"); }

}  // namespace leda::server
