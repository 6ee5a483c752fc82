#pragma once
// The case that a document holds as its "case" or, on the command line, names as its "case_file".

#include <functional>
#include <optional>
#include <string>

#include "server/documents/case_file.hpp"
#include "server/documents/object_reader.hpp"

namespace leda::server {

/// The text of the file that "case_file" names; nothing where it cannot be read.
using CaseReader = std::function<std::optional<std::string>(const std::string& file)>;

struct NamedCase {
  std::string at;                                      ///< pointer to where its faults stand
  nlohmann::json document = nlohmann::json::object();  ///< as given
  Parsed<CaseFile> of;
};

/// @param read_file nullptr: "case_file" is not known
NamedCase read_named_case(ObjectReader& reader, const CaseReader* read_file, FaultList& faults);

}  // namespace leda::server
