#include "server/documents/named_case.hpp"

#include <fmt/format.h>

#include <utility>

#include "server/documents/json_syntax.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

/// Faults of a file stand at its name.
NamedCase from_text(const std::string& name, const std::string& text, std::string at) {
  NamedCase named{std::move(at), {}, {}};
  auto parsed = parse_json(text);
  named.of.faults = std::move(parsed.faults);
  if (parsed) {
    named.of = read_case_file(*parsed.value);
    named.document = std::move(*parsed.value);
  }
  for (Fault& fault : named.of.faults) {
    fault.message.insert(0, fmt::format("{} {}: ", name, fault.pointer));
    fault.pointer = named.at;
  }
  return named;
}

}  // namespace

NamedCase read_named_case(ObjectReader& reader, const CaseReader* read_file, FaultList& faults) {
  const json* file = read_file ? reader.find("case_file") : nullptr;
  if (!file) {
    const std::string at = reader.at("case");
    const json* document = reader.require("case");
    return document ? NamedCase{at, *document, read_case_file(*document, at)}
                    : NamedCase{at, {}, {}};
  }
  const std::string at = reader.at("case_file");
  if (reader.find("case")) faults.add(at, "stands beside case: give one of the two");
  const std::string name = read_text(*file, at, 4096, faults);
  if (name.empty()) return {at, {}, {}};
  const auto text = (*read_file)(name);
  if (!text) {
    faults.add(at, "is \"" + name + "\", which cannot be read");
    return {at, {}, {}};
  }
  return from_text(name, *text, at);
}

}  // namespace leda::server
