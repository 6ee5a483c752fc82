#pragma once
// Every fault of a section and its settings at once.

#include <string>
#include <vector>

#include "solver/section/run_settings.hpp"
#include "solver/section/section.hpp"

namespace leda {

struct Fault {
  std::string pointer;  ///< JSON pointer into the case file, e.g. /materials/S1/poisson_ratio
  std::string message;  ///< the value, and what would be right
};

/// Limits that keep one section within one worker.
inline constexpr std::int64_t most_particles = 20'000'000;

/// @return empty when the section can be simulated
std::vector<Fault> validate(const Section& section, const RunSettings& settings);

/// Faults of settings alone: what can be said without the ground.
std::vector<Fault> validate_settings(const RunSettings& settings);

/// Faults of materials alone; pointers start at `at` (for example "/materials").
std::vector<Fault> validate_materials(const std::map<std::string, Material>& materials,
                                      const std::string& at);

}  // namespace leda
