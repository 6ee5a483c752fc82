#pragma once
// A distribution of an uncertain input: {"type": "lognormal", "mean": 1, "cov": 0.15}.

#include "server/documents/object_reader.hpp"
#include "solver/ensemble/distribution.hpp"

namespace leda::server {

/// Every fault at once, those of the parameters' meaning too.
solver::Distribution read_distribution(const nlohmann::json& value, const std::string& at,
                                       FaultList& faults);

}  // namespace leda::server
