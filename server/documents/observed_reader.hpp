#pragma once
// What was seen of a past slide: {"retrogression_m": {"value": 100, "sd_ln": 0.05}, "runout_m":
// {"at_least": 40}}.

#include "server/documents/object_reader.hpp"
#include "solver/hindcast/observation.hpp"

namespace leda::server {

/// Sets both distances of a slide.
void read_observed(const nlohmann::json& value, const std::string& at, solver::PastSlide& slide,
                   FaultList& faults);

solver::Discrepancy read_discrepancy(const nlohmann::json& value, const std::string& at,
                                     FaultList& faults);

}  // namespace leda::server
