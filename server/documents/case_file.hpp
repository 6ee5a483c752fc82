#pragma once
// The case file: one section and how to run it, as JSON with the units in the names.
// Format: README.md of this folder; published schema: schema/case.json.

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "server/documents/parsed.hpp"
#include "solver/section/run_settings.hpp"
#include "solver/section/section.hpp"

namespace leda::server {

struct CaseFile {
  Section section;
  RunSettings settings;
};

/// Every fault at once, each with its pointer: syntax, unknown keys, wrong types, and what
/// validate() finds.
Parsed<CaseFile> parse_case_file(std::string_view text);

/// The same for a case inside another document. @param at pointer to it, "" at the root
Parsed<CaseFile> read_case_file(const nlohmann::json& document, const std::string& at = "");

nlohmann::json to_document(const CaseFile& case_file);

/// One text for all documents that mean the same: keys sorted, defaults written out, no white
/// space. Parsing it gives the same CaseFile to the last bit if that one came from a document.
std::string canonical_text(const CaseFile& case_file);

/// Hex digits of the sha256 of the canonical text.
std::string case_sha256(const CaseFile& case_file);

}  // namespace leda::server
