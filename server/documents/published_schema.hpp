#pragma once
// The published JSON schemas (draft-07), part of the binary. Sources: schema/*.json.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "solver/section/validate.hpp"

namespace leda::server {

/// `ensemble`: the member of that name.
enum class PublishedSchema {
  case_file,
  ensemble,
  hindcast_request,
  region_request,
  simulate_request,
  study_request
};

/// The whole schema with its definitions, as served to clients.
const nlohmann::json& published_schema(PublishedSchema which);

/// Where a document does not match a published schema. @param at pointer to the document
std::vector<Fault> schema_faults(PublishedSchema which, const nlohmann::json& document,
                                 const std::string& at = "");

}  // namespace leda::server
