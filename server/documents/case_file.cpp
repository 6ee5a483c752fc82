#include "server/documents/case_file.hpp"

#include <utility>

#include "disk/sha256.hpp"
#include "server/documents/json_syntax.hpp"
#include "server/documents/object_reader.hpp"
#include "server/documents/published_schema.hpp"
#include "server/documents/settings_reader.hpp"
#include "server/documents/soil_reader.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

/// `layers`, or `columns` in their place.
void read_soil_along(ObjectReader& reader, Section& section, FaultList& faults) {
  const json* columns = reader.find("columns");
  if (columns) section.columns = read_columns(*columns, reader.at("columns"), faults);
  const json* layers = columns ? reader.find("layers") : reader.require("layers");
  if (!layers) return;
  section.layers = read_layers(*layers, reader.at("layers"), faults);
  if (columns) faults.add(reader.at("columns"), "stands beside layers: give one of the two");
}

CaseFile read_members(ObjectReader& reader, std::set<std::string>& derived, FaultList& faults) {
  CaseFile out;
  Section& section = out.section;
  section.name = reader.text("name");
  if (const json* v = reader.require("ground")) {
    section.ground = read_polyline(*v, reader.at("ground"), faults);
  }
  section.base_m = reader.number("base_m");
  if (const json* v = reader.find("water_table")) {
    section.water_table = read_water_table(*v, reader.at("water_table"), faults);
  }
  read_soil_along(reader, section, faults);
  if (const json* v = reader.require("materials")) {
    ReadMaterials read = read_materials(*v, reader.at("materials"), faults);
    section.materials = std::move(read.materials);
    derived = std::move(read.derived);
  }
  section.crest = reader.optional_point("crest_m");
  section.toe = reader.optional_point("toe_m");
  out.settings = read_settings(reader, faults);
  reader.refuse_unknown();
  return out;
}

/// What validate() finds, with pointers into this document. A shear modulus that was worked out
/// is not in it; the Young's modulus it came from was checked when it was read.
std::vector<Fault> faults_of(const CaseFile& read, const std::string& at,
                             const std::set<std::string>& derived) {
  std::vector<Fault> found;
  for (Fault& fault : validate(read.section, read.settings)) {
    fault.pointer.insert(0, at);
    if (!derived.contains(fault.pointer)) found.push_back(std::move(fault));
  }
  return found;
}

}  // namespace

Parsed<CaseFile> read_case_file(const json& document, const std::string& at) {
  FaultList list;
  ObjectReader reader(document, at, list);
  std::set<std::string> derived;
  CaseFile read = read_members(reader, derived, list);
  std::vector<Fault> faults = list.take();
  add_new_faults(faults, faults_of(read, at, derived));
  if (faults.empty()) faults = schema_faults(PublishedSchema::case_file, document, at);
  if (!faults.empty()) return {std::nullopt, std::move(faults)};
  return {std::move(read), {}};
}

Parsed<CaseFile> parse_case_file(std::string_view text) {
  auto parsed = parse_json(text);
  if (!parsed) return {std::nullopt, std::move(parsed.faults)};
  return read_case_file(*parsed.value);
}

std::string canonical_text(const CaseFile& case_file) { return to_document(case_file).dump(); }

std::string case_sha256(const CaseFile& case_file) {
  return disk::sha256_of(canonical_text(case_file));
}

}  // namespace leda::server
