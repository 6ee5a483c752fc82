#pragma once
// From the published JSON schemas (draft-07) to the schemas of OpenAPI 3.0, which are their own
// kind.

#include <nlohmann/json.hpp>

namespace leda::server {

/// The schema without its definitions; references lead to #/components/schemas.
nlohmann::json to_openapi(const nlohmann::json& schema);

/// Every schema that the description of the interface refers to, by name: those of
/// schema/api.json, the three requests ("map-region-request", ...) and all they define.
nlohmann::json openapi_schemas();

/// Query parameters by name, as schema/api.json describes them.
nlohmann::json openapi_parameters();

}  // namespace leda::server
