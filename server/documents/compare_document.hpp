#pragma once
// Sections beside each other: numbers as JSON, profiles as a drawing.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "solver/section/section_result.hpp"

namespace leda::server {

struct ComparedSection {
  std::string name;
  std::string state;  ///< as stored: "finished", "stable", "failed", ...
  Polyline ground;    ///< before, m
  Point crest, toe;
  std::optional<SectionResult> result;
  nlohmann::json screening;  ///< as stored; null: not screened
};

/// {"sections": [...], "differences": [{"from", "to", ...}]}: each section against the first,
/// later minus first; a difference is null where one of the two has no usable result or is a lower
/// bound, and its "unknown" says why.
/// @pre at least two sections
nlohmann::json compare_json(const std::vector<ComparedSection>& sections);

/// One panel a section, all at one scale (heights as lengths), m. SVG 1.1, self-contained.
std::string compare_svg(const std::vector<ComparedSection>& sections);

}  // namespace leda::server
