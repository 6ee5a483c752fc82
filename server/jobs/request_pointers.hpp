#pragma once
// From a place in the parsed request to the JSON pointer of what the user wrote.

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "profiles/build_section.hpp"
#include "solver/section/run_settings.hpp"

namespace leda::server {

/// @param pointer into the layout: "/lines/0/line/1", "/along/0/spacing_m"
/// @return into the request: "/inputs/sections/2/line/1", "/inputs/sections/spacing_m"
std::string layout_pointer(const nlohmann::json& request, const std::string& pointer);

/// @param pointer into the list of soil models: "/0/layers/1/bottom_m"
std::string soil_pointer(const nlohmann::json& request, const std::string& pointer);

/// @param pointer into the case of one section: "/materials/S1/k0", "/resolution/cell_m"
/// @param model index of the soil model it was built from
std::string case_pointer(const nlohmann::json& request, const std::string& pointer,
                         std::size_t model);

/// What is wrong with a section as it would be run: soil that does not fit its profile, else what
/// validation finds.
std::vector<Fault> faults_of(const profiles::BuiltSection& built, const RunSettings& settings,
                             const nlohmann::json& request);

}  // namespace leda::server
