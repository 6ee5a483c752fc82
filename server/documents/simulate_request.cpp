#include "server/documents/simulate_request.hpp"

#include <utility>

#include "server/documents/execute_options.hpp"
#include "server/documents/json_syntax.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

/// @param faults of the case and the ensemble
std::optional<SimulateRequest> read_inputs(ObjectReader& reader, Members members,
                                           std::vector<Fault>& faults) {
  const json* document = reader.require("case");
  const json* ensemble = reader.find("ensemble");
  if (document == nullptr) return std::nullopt;
  if (ensemble == nullptr) {
    auto read = read_case_file(*document, reader.at("case"));
    faults = std::move(read.faults);
    if (!read) return std::nullopt;
    return SimulateRequest{std::move(*read.value), std::nullopt};
  }
  auto read =
      read_ensemble_case(*document, reader.at("case"), *ensemble, reader.at("ensemble"), members);
  faults = std::move(read.faults);
  if (!read) return std::nullopt;
  CaseFile of = read.value->of;
  return SimulateRequest{std::move(of), std::move(*read.value)};
}

}  // namespace

Parsed<SimulateRequest> parse_simulate_request(std::string_view text, Members members) {
  auto parsed = parse_json(text);
  if (!parsed) return {std::nullopt, std::move(parsed.faults)};
  FaultList list;
  ObjectReader body(*parsed.value, "", list);
  Parsed<SimulateRequest> result;
  if (const json* inputs = body.require("inputs")) {
    ObjectReader reader(*inputs, "/inputs", list);
    result.value = read_inputs(reader, members, result.faults);
    reader.refuse_unknown();
  }
  read_execute_options(body, list);
  body.refuse_unknown();
  for (Fault& fault : list.take()) result.faults.push_back(std::move(fault));
  if (!result.faults.empty()) result.value.reset();
  return result;
}

}  // namespace leda::server
