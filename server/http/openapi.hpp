#pragma once
// The interface described as OpenAPI 3.0, made from the table of routes.

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace leda::server {

/// @param url of the service  @param with_tokens whether requests must carry one
nlohmann::json openapi_document(const std::string& url, bool with_tokens);

}  // namespace leda::server
