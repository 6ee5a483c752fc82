#pragma once
// What a worker leaves, without a worker: for tests of what the server makes of it.

#include <filesystem>
#include <string>

#include "solver/section/section_result.hpp"

namespace leda::tests {

/// A small sound case, and the request that asks for it.
std::string small_case();
std::string simulate_request();

/// A result of the case in the folder's case.json.
SectionResult result_of_case_in(const std::filesystem::path& folder);

/// A result of no case in particular: at rest after 10 s, 45 ns a particle and step.
SectionResult made_up_result();

/// Writes fields.h5 (without a frame) and result.json, as a worker does at its end.
void leave_result(const std::filesystem::path& folder, const SectionResult& result);

void write_text(const std::filesystem::path& file, const std::string& text);
std::string read_text(const std::filesystem::path& file);

}  // namespace leda::tests
