#include "server/documents/study_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace leda::server {
namespace {

using nlohmann::json;
using solver::study_axes;
using solver::StudySetting;

constexpr std::array particle_counts{1, 4, 9, 16, 25};
constexpr std::size_t most_values = 20;
constexpr int most_seeds = 50;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

bool check_cell(const std::string& at, double cell_m, FaultList& faults) {
  return faults.positive(at, cell_m, "m");
}

bool check_particles(const std::string& at, double count, FaultList& faults) {
  const bool known = std::ranges::find(particle_counts, count) != particle_counts.end();
  return faults.within(at, count, known, "one of 1, 4, 9, 16, 25");
}

bool check_time_step(const std::string& at, double factor, FaultList& faults) {
  return faults.within(at, factor, factor > 0 && factor <= 1, "greater than 0 and at most 1");
}

struct AxisRule {
  bool (*check)(const std::string& at, double value, FaultList& faults);
  bool may_be_absent;
  const char* place_in_case;  ///< faults there are the value's; empty: another axis tells them
};

/// By axis. Too many particles, for example, are told of the cell size.
constexpr std::array axis_rules{AxisRule{check_cell, false, "/resolution"},
                                AxisRule{check_particles, false, ""},
                                AxisRule{check_time_step, true, "/time_step_factor"}};
static_assert(axis_rules.size() == study_axes.size());

struct Given {
  double value = 0;
  std::string at;
};

/// A list of different numbers; those at fault are NaN.
std::vector<double> read_numbers(const json& value, const std::string& at, FaultList& faults) {
  if (!value.is_array() || value.empty() || value.size() > most_values) {
    faults.add(at, fmt::format("is {}, must be a list of 1 to {} numbers",
                               value.is_array() ? fmt::format("a list of {}", value.size())
                                                : kind_of(value),
                               most_values));
    return {};
  }
  std::vector<double> numbers;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::string here = fmt::format("{}/{}", at, i);
    const double number = read_number(value[i], here, faults);
    if (std::ranges::find(numbers, number) != numbers.end()) {
      faults.add(here, "is " + show(number) + " again: every value once");
      numbers.push_back(not_a_number);  // keeps the places of those after it
      continue;
    }
    numbers.push_back(number);
  }
  return numbers;
}

/// The sound values of one axis of the grid.
std::vector<Given> read_axis(ObjectReader& reader, std::size_t axis, const StudySetting& own,
                             FaultList& faults) {
  const AxisRule& rule = axis_rules[axis];
  const char* key = study_axes[axis].key;
  const json* value = rule.may_be_absent ? reader.find(key) : reader.require(key);
  if (!value && rule.may_be_absent) return {{study_axes[axis].value(own), ""}};
  if (!value) return {};
  std::vector<Given> sound;
  const auto numbers = read_numbers(*value, reader.at(key), faults);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    std::string at = fmt::format("{}/{}", reader.at(key), i);
    if (std::isnan(numbers[i]) || !rule.check(at, numbers[i], faults)) continue;
    sound.push_back({numbers[i], std::move(at)});
  }
  return sound;
}

/// The value of one axis in an item of `also`; nothing where it is at fault.
std::optional<Given> read_value(ObjectReader& item, std::size_t axis, const StudySetting& own,
                                FaultList& faults) {
  const AxisRule& rule = axis_rules[axis];
  const char* key = study_axes[axis].key;
  const auto number =
      rule.may_be_absent ? item.optional_number(key) : std::optional(item.number(key));
  if (!number) return Given{study_axes[axis].value(own), ""};
  if (std::isnan(*number) || !rule.check(item.at(key), *number, faults)) return std::nullopt;
  return Given{*number, item.at(key)};
}

AskedSetting with(AskedSetting asked, std::size_t axis, const Given& given) {
  study_axes[axis].set(asked.repeated.setting, given.value);
  asked.at[axis] = given.at;
  return asked;
}

int read_seeds(ObjectReader& reader, int absent, FaultList& faults) {
  return read_count(reader, "seeds", absent, most_seeds, faults);
}

std::optional<AskedSetting> read_item(ObjectReader& item, const StudySetting& own, int seeds,
                                      FaultList& faults) {
  std::optional<AskedSetting> asked(AskedSetting{});
  for (std::size_t axis = 0; axis < study_axes.size(); ++axis) {
    const auto given = read_value(item, axis, own, faults);
    if (asked && given) {
      asked = with(std::move(*asked), axis, *given);
    } else {
      asked.reset();
    }
  }
  const int own_seeds = read_seeds(item, seeds, faults);
  if (asked) asked->repeated.seeds = own_seeds;
  item.refuse_unknown();
  return asked;
}

void read_also(ObjectReader& reader, const StudySetting& own, int seeds,
               std::vector<AskedSetting>& asked, FaultList& faults) {
  const json* value = reader.find("also");
  if (!value) return;
  const std::string at = reader.at("also");
  if (!value->is_array() || value->size() > most_values) {
    faults.add(at, fmt::format("must be a list of at most {} settings", most_values));
    return;
  }
  for (std::size_t i = 0; i < value->size(); ++i) {
    ObjectReader item((*value)[i], fmt::format("{}/{}", at, i), faults);
    if (!item.is_object()) continue;
    if (auto one = read_item(item, own, seeds, faults)) asked.push_back(std::move(*one));
  }
}

}  // namespace

std::vector<AskedSetting> read_study_grid(ObjectReader& reader, const StudySetting& own,
                                          FaultList& faults) {
  std::vector<AskedSetting> grid(1);
  for (std::size_t axis = 0; axis < study_axes.size(); ++axis) {
    const auto values = read_axis(reader, axis, own, faults);
    std::vector<AskedSetting> wider;
    for (const AskedSetting& one : grid) {
      for (const Given& given : values) wider.push_back(with(one, axis, given));
    }
    grid = std::move(wider);
  }
  const int seeds = read_seeds(reader, 3, faults);
  for (AskedSetting& one : grid) one.repeated.seeds = seeds;
  read_also(reader, own, seeds, grid, faults);
  return grid;
}

std::string place_of(const AskedSetting& asked, const std::string& fault_of_case) {
  for (std::size_t axis = 0; axis < study_axes.size(); ++axis) {
    const std::string_view place = axis_rules[axis].place_in_case;
    if (!place.empty() && fault_of_case.starts_with(place)) return asked.at[axis];
  }
  return "";
}

}  // namespace leda::server
