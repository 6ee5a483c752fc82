#pragma once
// result.json and profile_after.csv: what a run says, written and read back.

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "server/documents/parsed.hpp"
#include "solver/section/section_result.hpp"

namespace leda::server {

/// Never holds a value that is not finite: such a result becomes unstable, its reason names the
/// value, and 0 stands in its place.
nlohmann::json to_document(const SectionResult& as_run);

/// `engine` of a result.
nlohmann::json to_document(const Engine& engine);

/// The document as written to result.json: two spaces of indent, a line feed at the end.
std::string result_text(const SectionResult& result);

/// Strict: a missing, unknown or impossible value is a fault.
Parsed<SectionResult> parse_result(std::string_view text);

/// "x_m,z_m" and one line a point, shortest digits that give the same number back.
std::string profile_csv(const Polyline& profile);

}  // namespace leda::server
