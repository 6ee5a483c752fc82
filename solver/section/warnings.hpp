#pragma once
// What is odd about a section and its settings, but possible: told before a run and with its
// result. What is impossible is a fault (validate.hpp).

#include <string>
#include <vector>

#include "solver/section/run_settings.hpp"
#include "solver/section/section.hpp"

namespace leda {

/// @pre validate(section, settings) is empty
std::vector<std::string> warnings_of(const Section& section, const RunSettings& settings);

/// Of materials alone: magnitudes that few soils have.
std::vector<std::string> warnings_of(const std::map<std::string, Material>& materials);

/// Adds the warnings that are not there yet: what is known before a run comes again with its
/// result.
void add_new(std::vector<std::string>& warnings, const std::vector<std::string>& more);

}  // namespace leda
