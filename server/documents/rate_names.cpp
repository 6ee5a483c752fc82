#include "server/documents/rate_names.hpp"

#include <variant>

#include "server/documents/object_reader.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

struct WriteRate {
  json operator()(const SemiLogarithmicRate& law) const {
    return {{"law", "semi-logarithmic"},
            {"per_decade", law.per_decade},
            {"reference_rate_per_s", law.reference_rate}};
  }
  json operator()(const PowerRate& law) const {
    return {
        {"law", "power"}, {"exponent", law.exponent}, {"reference_rate_per_s", law.reference_rate}};
  }
  json operator()(const AdditivePowerRate& law) const {
    return {{"law", "additive-power"},
            {"viscosity", law.viscosity},
            {"exponent", law.exponent},
            {"reference_rate_per_s", law.reference_rate}};
  }
};

struct WriteFlow {
  json operator()(const BinghamFlow& law) const {
    return {{"law", "bingham"}, {"viscosity_Pa_s", law.viscosity_Pa_s}};
  }
  json operator()(const HerschelBulkleyFlow& law) const {
    return {{"law", "herschel-bulkley"},
            {"consistency_Pa_sn", law.consistency_Pa_sn},
            {"exponent", law.exponent}};
  }
};

void unknown(const ObjectReader& reader, const std::string& law, const char* known,
             FaultList& faults) {
  if (!law.empty()) {
    faults.add(reader.at("law"), "is \"" + law + "\", must be one of " + known);
  }
}

}  // namespace

std::optional<RateLaw> read_rate(const json& value, const std::string& at, FaultList& faults,
                                 const std::string& beside) {
  ObjectReader reader(value, at, faults);
  const std::string law = reader.text("law");
  std::optional<RateLaw> rate;
  const auto reference = [&] { return reader.number("reference_rate_per_s"); };
  if (law == "semi-logarithmic") {
    rate = SemiLogarithmicRate{reader.number("per_decade"), reference()};
  } else if (law == "power") {
    rate = PowerRate{reader.number("exponent"), reference()};
  } else if (law == "additive-power") {
    rate = AdditivePowerRate{reader.number("viscosity"), reader.number("exponent"), reference()};
  } else {
    unknown(reader, law, "semi-logarithmic, power, additive-power", faults);
    return rate;
  }
  if (!beside.empty()) reader.find(beside);
  reader.refuse_unknown();
  return rate;
}

std::optional<FlowLaw> read_flow(const json& value, const std::string& at, FaultList& faults) {
  ObjectReader reader(value, at, faults);
  const std::string law = reader.text("law");
  std::optional<FlowLaw> flow;
  if (law == "bingham") {
    flow = BinghamFlow{reader.number("viscosity_Pa_s")};
  } else if (law == "herschel-bulkley") {
    flow = HerschelBulkleyFlow{reader.number("consistency_Pa_sn"), reader.number("exponent")};
  } else {
    unknown(reader, law, "bingham, herschel-bulkley", faults);
    return flow;
  }
  reader.refuse_unknown();
  return flow;
}

json to_document(const RateLaw& law) { return std::visit(WriteRate{}, law); }
json to_document(const FlowLaw& law) { return std::visit(WriteFlow{}, law); }

}  // namespace leda::server
