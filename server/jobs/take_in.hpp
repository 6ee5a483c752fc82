#pragma once
// From the folder of a run to its result: what a worker left is checked before it counts.

#include <filesystem>
#include <optional>
#include <string>

#include "solver/section/section_result.hpp"

namespace leda::server {

struct Outcome {
  std::optional<SectionResult> result;  ///< whole, and of the case in the same folder
  std::string document;                 ///< result.json as written
  std::string fault;                    ///< why there is no result
};

/// fields.h5 of a run that has its result: kept, and needed for the result to count, or removed.
enum class Fields { kept, removed };

Outcome read_outcome(const std::filesystem::path& run_folder, Fields fields = Fields::kept);

/// Share of the run that is done, 0 to 1, from its progress.json; 0 where there is none.
double read_fraction(const std::filesystem::path& run_folder);

/// The last line of the worker's log that says something; at most 400 characters.
std::string last_words(const std::filesystem::path& run_folder);

}  // namespace leda::server
