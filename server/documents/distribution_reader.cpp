#include "server/documents/distribution_reader.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace leda::server {
namespace {

using nlohmann::json;
using solver::Distribution;

constexpr std::size_t most_values = 10'000;

Distribution read_normal(ObjectReader& reader) {
  solver::Normal d;
  d.mean = reader.number("mean");
  d.sd = reader.number("sd");
  d.min = reader.optional_number("min");
  d.max = reader.optional_number("max");
  return d;
}

/// By "mean" and "cov", or by "median" and "sd_ln".
Distribution read_lognormal(ObjectReader& reader, const std::string& at, FaultList& faults) {
  const bool by_mean = reader.find("mean") != nullptr || reader.find("cov") != nullptr;
  const bool by_median = reader.find("median") != nullptr || reader.find("sd_ln") != nullptr;
  if (by_mean == by_median) {
    faults.add(at, "must have \"mean\" and \"cov\", or \"median\" and \"sd_ln\"");
    return solver::Lognormal{};
  }
  if (by_median) return solver::Lognormal{reader.number("median"), reader.number("sd_ln")};
  const double mean = reader.number("mean"), cov = reader.number("cov");
  bool sound = std::isfinite(mean) && std::isfinite(cov);
  if (sound) sound = faults.within(reader.at("mean"), mean, mean > 0, "greater than 0");
  if (std::isfinite(cov)) {
    sound =
        faults.within(reader.at("cov"), cov, cov > 0 && cov <= 3, "above 0 and at most 3") && sound;
  }
  return sound ? solver::lognormal_of_mean(mean, cov) : solver::Lognormal{};
}

template <class Peaked>
Distribution read_peaked(ObjectReader& reader) {
  return Peaked{reader.number("min"), reader.number("mode"), reader.number("max")};
}

std::vector<double> read_numbers(ObjectReader& reader, const char* key, FaultList& faults) {
  const json* value = reader.require(key);
  if (value == nullptr) return {};
  if (!value->is_array() || value->empty() || value->size() > most_values) {
    faults.add(reader.at(key), (value->is_array() ? fmt::format("has {} numbers", value->size())
                                                  : "is " + kind_of(*value)) +
                                   fmt::format(", must be a list of 1 to {} numbers", most_values));
    return {};
  }
  std::vector<double> numbers;
  for (std::size_t i = 0; i < value->size(); ++i) {
    numbers.push_back(read_number((*value)[i], fmt::format("{}/{}", reader.at(key), i), faults));
  }
  return numbers;
}

Distribution read_of_type(const std::string& type, ObjectReader& reader, const std::string& at,
                          FaultList& faults) {
  if (type == "normal") return read_normal(reader);
  if (type == "lognormal") return read_lognormal(reader, at, faults);
  if (type == "uniform") return solver::Uniform{reader.number("min"), reader.number("max")};
  if (type == "triangular") return read_peaked<solver::Triangular>(reader);
  if (type == "pert") return read_peaked<solver::Pert>(reader);
  if (type == "discrete") {
    auto values = read_numbers(reader, "values", faults);
    return solver::Discrete{std::move(values), read_numbers(reader, "weights", faults)};
  }
  if (type == "sample") {
    std::string set = reader.text("set", 100);
    auto values = read_numbers(reader, "values", faults);
    return solver::JointSample{std::move(set), std::move(values),
                               read_numbers(reader, "weights", faults)};
  }
  faults.add(reader.at("type"), "is \"" + type +
                                    "\", must be normal, lognormal, uniform, triangular, pert, "
                                    "discrete or sample");
  return solver::Uniform{};
}

}  // namespace

Distribution read_distribution(const json& value, const std::string& at, FaultList& faults) {
  FaultList own;
  ObjectReader reader(value, at, own);
  const std::string type = reader.text("type", 20);
  Distribution distribution =
      type.empty() ? Distribution(solver::Uniform{}) : read_of_type(type, reader, at, own);
  reader.refuse_unknown();
  auto found = own.take();
  // Numbers that could not be read would only be found wrong again.
  if (found.empty()) {
    solver::check(distribution, at, own);
    found = own.take();
  }
  for (Fault& fault : found) faults.add(std::move(fault.pointer), std::move(fault.message));
  return distribution;
}

}  // namespace leda::server
