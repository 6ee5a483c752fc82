#include "server/documents/observed_reader.hpp"

#include <cmath>

namespace leda::server {
namespace {

using nlohmann::json;
using solver::Observed;

constexpr double largest_sd_ln = 3;

std::optional<double> read_distance(ObjectReader& reader, const char* key, FaultList& faults) {
  const auto distance = reader.optional_number(key);
  if (distance && !std::isnan(*distance)) faults.positive(reader.at(key), *distance, "m");
  return distance;
}

/// A number within bounds; `absent` where it is absent.
double read_sd_ln(ObjectReader& reader, const char* key, double absent, FaultList& faults) {
  const double sd = reader.number_or(key, absent);
  if (!std::isnan(sd)) {
    faults.within(reader.at(key), sd, sd >= 0 && sd <= largest_sd_ln,
                  "at least 0 and at most " + show(largest_sd_ln));
  }
  return sd;
}

Observed read_one(const json& value, const std::string& at, FaultList& faults) {
  ObjectReader reader(value, at, faults);
  Observed o;
  o.value_m = read_distance(reader, "value", faults);
  o.at_least_m = read_distance(reader, "at_least", faults);
  o.at_most_m = read_distance(reader, "at_most", faults);
  const bool has_error = reader.find("sd_ln") != nullptr;
  if (o.value_m && (o.at_least_m || o.at_most_m)) {
    faults.add(
        at, "has a value and bounds: give \"value\" and \"sd_ln\", or \"at_least\", \"at_most\"");
  } else if (o.value_m) {
    o.sd_ln = has_error ? read_sd_ln(reader, "sd_ln", 0, faults) : reader.number("sd_ln");
  } else if (has_error) {
    faults.add(reader.at("sd_ln"), "is the survey's error of a value, and there is none");
  } else if (!o.at_least_m && !o.at_most_m && reader.is_object()) {
    faults.add(at, "says nothing: give \"value\" and \"sd_ln\", or \"at_least\", \"at_most\"");
  }
  if (o.at_least_m && o.at_most_m && !(*o.at_most_m > *o.at_least_m)) {
    faults.add(reader.at("at_most"), "is " + show(*o.at_most_m) +
                                         ", must be greater than at_least, " + show(*o.at_least_m));
  }
  reader.refuse_unknown();
  return o;
}

}  // namespace

void read_observed(const json& value, const std::string& at, solver::PastSlide& slide,
                   FaultList& faults) {
  ObjectReader reader(value, at, faults);
  if (const json* v = reader.find("retrogression_m")) {
    slide.retrogression = read_one(*v, reader.at("retrogression_m"), faults);
  }
  if (const json* v = reader.find("runout_m")) {
    slide.runout = read_one(*v, reader.at("runout_m"), faults);
  }
  if (reader.is_object() && !slide.retrogression && !slide.runout) {
    faults.add(at, "names no distance: give retrogression_m, runout_m or both");
  }
  reader.refuse_unknown();
}

solver::Discrepancy read_discrepancy(const json& value, const std::string& at, FaultList& faults) {
  ObjectReader reader(value, at, faults);
  solver::Discrepancy d;
  d.sd_ln = reader.number_or("sd_ln", d.sd_ln);
  if (!std::isnan(d.sd_ln)) {
    faults.within(reader.at("sd_ln"), d.sd_ln, d.sd_ln > 0 && d.sd_ln <= largest_sd_ln,
                  "above 0 and at most " + show(largest_sd_ln));
  }
  d.correlation = reader.number_or("correlation", d.correlation);
  if (!std::isnan(d.correlation)) {
    faults.within(reader.at("correlation"), d.correlation, d.correlation >= 0 && d.correlation < 1,
                  "at least 0 and below 1");
  }
  d.bias_sd_ln = read_sd_ln(reader, "bias_sd_ln", d.bias_sd_ln, faults);
  reader.refuse_unknown();
  return d;
}

}  // namespace leda::server
