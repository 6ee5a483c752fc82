#pragma once
// Rate and flow laws between their names in a document and their parameters, both ways.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "solver/section/fault_list.hpp"
#include "solver/section/rate.hpp"

namespace leda::server {

/// Nothing, and a fault, where the law is not known: what its members mean is not known either.
/// @param beside a key that stands beside those of the law; empty: none
std::optional<RateLaw> read_rate(const nlohmann::json& value, const std::string& at,
                                 FaultList& faults, const std::string& beside = "");
std::optional<FlowLaw> read_flow(const nlohmann::json& value, const std::string& at,
                                 FaultList& faults);

nlohmann::json to_document(const RateLaw& law);
nlohmann::json to_document(const FlowLaw& law);

}  // namespace leda::server
