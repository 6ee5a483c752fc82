#include "server/documents/ensemble_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "server/documents/distribution_reader.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using solver::EnsemblePlan;
using solver::Method;

/// The list of a member, or nothing with a fault where it is none or of another size.
const json* list_of(const json* value, const std::string& at, std::size_t least, std::size_t most,
                    FaultList& faults) {
  if (value == nullptr) return nullptr;
  if (value->is_array() && value->size() >= least && value->size() <= most) return value;
  faults.add(at, (value->is_array() ? fmt::format("has {} items", value->size())
                                    : "is " + kind_of(*value)) +
                     fmt::format(", must be a list of {} to {} items", least, most));
  return nullptr;
}

/// A word of a small vocabulary; the first one where it is absent or wrong.
template <class Word>
Word read_word(ObjectReader& reader, const char* key, std::initializer_list<Word> words,
               FaultList& faults) {
  const json* value = reader.find(key);
  if (value == nullptr) return *words.begin();
  std::string known;
  for (const Word word : words) {
    if (*value == to_string(word)) return word;
    known += (known.empty() ? "" : ", ") + std::string(to_string(word));
  }
  faults.add(reader.at(key), "is " + value->dump() + ", must be one of " + known);
  return *words.begin();
}

/// A whole number within bounds; `absent` where it is absent or wrong.
std::size_t read_count(ObjectReader& reader, const char* key, std::size_t absent, std::size_t least,
                       std::size_t most, FaultList& faults) {
  const std::int64_t count = reader.integer_or(key, std::int64_t(absent));
  if (count >= std::int64_t(least) && count <= std::int64_t(most)) return std::size_t(count);
  faults.add(reader.at(key), fmt::format("is {}, must be {} to {}", count, least, most));
  return absent;
}

double read_between(ObjectReader& reader, const char* key, double absent, double least, double most,
                    FaultList& faults) {
  const double value = reader.number_or(key, absent);
  if (std::isnan(value)) return absent;
  const std::string range = fmt::format("at least {} and at most {}", show(least), show(most));
  return faults.within(reader.at(key), value, value >= least && value <= most, range) ? value
                                                                                      : absent;
}

void read_input(const json& value, const std::string& at, EnsembleRequest& request,
                FaultList& faults) {
  ObjectReader reader(value, at, faults);
  solver::UncertainInput input;
  input.name = reader.text("name", 100);
  if (input.name.find_first_of(",\"\r\n") != std::string::npos) {
    faults.add(reader.at("name"), "must not hold commas and quotes: it names a column of CSV");
  }
  const bool again = std::ranges::any_of(
      request.plan.inputs, [&](const auto& other) { return other.name == input.name; });
  if (again && !input.name.empty()) {
    faults.add(reader.at("name"), "is \"" + input.name + "\", which another input has already");
  }
  InputPlace place;
  place.path = reader.text("path", 1000);
  place.apply = read_word(reader, "apply", {Apply::set, Apply::scale, Apply::add}, faults);
  input.scope =
      read_word(reader, "scope",
                {solver::Scope::section, solver::Scope::soil, solver::Scope::region}, faults);
  if (const json* v = reader.require("distribution")) {
    input.distribution = read_distribution(*v, reader.at("distribution"), faults);
  }
  reader.refuse_unknown();
  request.plan.inputs.push_back(std::move(input));
  request.places.push_back(std::move(place));
}

/// Columns of one table have the same rows.
void check_tables(const EnsemblePlan& plan, const std::string& at, FaultList& faults) {
  const auto table_of = [&](std::size_t i) {
    return std::get_if<solver::JointSample>(&plan.inputs[i].distribution);
  };
  for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto *a = table_of(i), *b = table_of(j);
      if (a == nullptr || b == nullptr || a->set != b->set) continue;
      if (a->weights != b->weights || plan.inputs[i].scope != plan.inputs[j].scope) {
        faults.add(fmt::format("{}/{}/distribution", at, i),
                   "has other weights or another scope than input \"" + plan.inputs[j].name +
                       "\" of the same set");
      }
      break;
    }
  }
}

std::optional<std::size_t> input_of(const EnsemblePlan& plan, const json& name,
                                    const std::string& at, FaultList& faults) {
  for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
    if (name != plan.inputs[i].name) continue;
    if (is_continuous(plan.inputs[i].distribution)) return i;
    faults.add(at,
               "is " + name.dump() + ", which has steps: only continuous inputs are correlated");
    return std::nullopt;
  }
  faults.add(at, "is " + name.dump() + ", must be the name of an input");
  return std::nullopt;
}

void read_correlation(const json& value, const std::string& at, EnsemblePlan& plan,
                      FaultList& faults) {
  ObjectReader reader(value, at, faults);
  const std::string between = reader.at("between");
  const json* pair = list_of(reader.require("between"), between, 2, 2, faults);
  const double rho = reader.number("rho");
  if (!std::isnan(rho)) {
    faults.within(reader.at("rho"), rho, rho > -1 && rho < 1, "above -1 and below 1");
  }
  reader.refuse_unknown();
  if (pair == nullptr || !(std::abs(rho) < 1)) return;
  const auto first = input_of(plan, (*pair)[0], between + "/0", faults);
  const auto second = input_of(plan, (*pair)[1], between + "/1", faults);
  if (!first || !second) return;
  const bool told = std::ranges::any_of(plan.correlations, [&](const auto& c) {
    return std::minmax(c.first, c.second) == std::minmax(*first, *second);
  });
  if (*first == *second || told) {
    faults.add(between, "must be two inputs, and each pair stands once");
    return;
  }
  plan.correlations.push_back({*first, *second, rho});
}

void read_correlations(ObjectReader& reader, EnsemblePlan& plan, FaultList& faults) {
  const std::string at = reader.at("rank_correlations");
  const json* list = list_of(reader.find("rank_correlations"), at, 0, 1000, faults);
  if (list == nullptr) return;
  for (std::size_t i = 0; i < list->size(); ++i) {
    read_correlation((*list)[i], fmt::format("{}/{}", at, i), plan, faults);
  }
  if (!solver::Copula::make(plan.inputs.size(), plan.correlations)) {
    faults.add(at,
               "contradict each other: the matrix of the correlations is not positive definite");
  }
}

void read_sampling(ObjectReader& outer, EnsemblePlan& plan, FaultList& faults) {
  const json* value = outer.find("sampling");
  if (value == nullptr) return;
  ObjectReader reader(*value, outer.at("sampling"), faults);
  auto& sampling = plan.sampling;
  sampling.method =
      read_word(reader, "method", {Method::sobol, Method::latin, Method::random}, faults);
  const std::int64_t seed = reader.integer_or("seed", 1);
  if (seed < 0) faults.add(reader.at("seed"), fmt::format("is {}, must be at least 0", seed));
  sampling.seed = std::uint64_t(seed);
  if (sampling.method == Method::random) {
    sampling.replicates = 1;
    if (reader.find("replicates") != nullptr) {
      faults.add(reader.at("replicates"), "means nothing to independent members: leave it out");
    }
  } else {
    sampling.replicates = read_count(reader, "replicates", 8, 4, 64, faults);
  }
  reader.refuse_unknown();
}

/// Nets are whole, and hypercubes equal, only at these numbers of members.
void check_stop(const EnsemblePlan& plan, const std::string& at, FaultList& faults) {
  const std::size_t replicates = plan.sampling.replicates, least = plan.stop.min_members;
  const bool whole = least % replicates == 0 && (plan.sampling.method != Method::sobol ||
                                                 std::has_single_bit(least / replicates));
  if (!whole) {
    faults.add(at + "/min_members",
               fmt::format("is {}, must be {} replicates of {} members each", least, replicates,
                           plan.sampling.method == Method::sobol ? "1, 2, 4, 8, ..." : "as many"));
  }
  if (!is_doubling(plan.stop)) {
    faults.add(at + "/max_members",
               fmt::format("is {}, must be min_members ({}) doubled some times, since nets are "
                           "looked at whole",
                           plan.stop.max_members, least));
  }
}

void read_stop(ObjectReader& outer, EnsemblePlan& plan, FaultList& faults) {
  const json empty = json::object();
  const json* value = outer.find("stop");
  ObjectReader reader(value != nullptr ? *value : empty, outer.at("stop"), faults);
  auto& stop = plan.stop;
  FaultList own;
  stop.min_members = read_count(reader, "min_members", stop.min_members, 16, most_members, own);
  stop.max_members = read_count(reader, "max_members", std::max(stop.max_members, stop.min_members),
                                16, most_members, own);
  stop.half_width = read_between(reader, "half_width", stop.half_width, 0.001, 0.5, own);
  stop.confidence = read_between(reader, "confidence", stop.confidence, 0.5, 0.999, own);
  reader.refuse_unknown();
  auto found = own.take();
  if (found.empty()) {
    check_stop(plan, outer.at("stop"), own);
    found = own.take();
  }
  for (Fault& fault : found) faults.add(std::move(fault.pointer), std::move(fault.message));
}

void read_check(ObjectReader& outer, EnsemblePlan& plan, FaultList& faults) {
  const json* value = outer.find("check");
  if (value == nullptr) return;
  ObjectReader reader(*value, outer.at("check"), faults);
  solver::CheckRule check;
  check.cell_m = reader.optional_number("cell_m");
  if (check.cell_m && !std::isnan(*check.cell_m)) {
    faults.positive(reader.at("cell_m"), *check.cell_m, "m");
  }
  check.members = read_count(reader, "members", check.members, 2, plan.stop.min_members, faults);
  check.seeds = read_count(reader, "seeds", check.seeds, 1, 16, faults);
  if (!check.cell_m && check.seeds == 1) {
    faults.add(outer.at("check"), "checks nothing: give cell_m, or seeds of 2 or more");
  }
  reader.refuse_unknown();
  plan.check = check;
}

void read_exceedance(ObjectReader& reader, EnsemblePlan& plan, FaultList& faults) {
  const std::string at = reader.at("exceedance");
  const json* list = list_of(reader.find("exceedance"), at, 1, 20, faults);
  if (list == nullptr) return;
  plan.exceedance.clear();
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string here = fmt::format("{}/{}", at, i);
    const double p = read_number((*list)[i], here, faults);
    if (std::isnan(p)) continue;
    const double before = plan.exceedance.empty() ? 0 : plan.exceedance.back();
    faults.within(here, p, p > before && p < 1,
                  "above " + show(before) + " and below 1, the list rising");
    plan.exceedance.push_back(p);
  }
}

void read_raster(ObjectReader& outer, EnsembleRequest& request, FaultList& faults) {
  const json* value = outer.find("raster");
  if (value == nullptr) return;
  ObjectReader reader(*value, outer.at("raster"), faults);
  const double cell = reader.number("cell_m");
  if (!std::isnan(cell)) faults.positive(reader.at("cell_m"), cell, "m");
  reader.refuse_unknown();
  request.raster_cell_m = cell;
}

}  // namespace

const char* to_string(Apply apply) {
  switch (apply) {
    case Apply::set:
      return "set";
    case Apply::scale:
      return "scale";
    case Apply::add:
      return "add";
  }
  return "";
}

EnsembleRequest read_ensemble(const json& value, const std::string& at, FaultList& faults) {
  EnsembleRequest request;
  ObjectReader reader(value, at, faults);
  const std::string inputs = reader.at("inputs");
  if (const json* list =
          list_of(reader.require("inputs"), inputs, 1, most_uncertain_inputs, faults)) {
    for (std::size_t i = 0; i < list->size(); ++i) {
      read_input((*list)[i], fmt::format("{}/{}", inputs, i), request, faults);
    }
  }
  check_tables(request.plan, inputs, faults);
  read_correlations(reader, request.plan, faults);
  read_sampling(reader, request.plan, faults);
  read_stop(reader, request.plan, faults);
  read_check(reader, request.plan, faults);
  read_exceedance(reader, request.plan, faults);
  read_raster(reader, request, faults);
  reader.refuse_unknown();
  return request;
}

}  // namespace leda::server
