#pragma once
// How to run a section: the members that a case and a region have in common.

#include "server/documents/object_reader.hpp"
#include "solver/section/run_settings.hpp"

namespace leda::server {

/// Reads trigger, resolution, damping, time_step_factor, stop and output.
RunSettings read_settings(ObjectReader& reader, FaultList& faults);

/// The same members, defaults written out.
void write_settings(const RunSettings& settings, nlohmann::json& document);

}  // namespace leda::server
