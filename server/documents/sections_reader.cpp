#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "server/documents/map_shape.hpp"
#include "server/documents/region_readers.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

/// A section's line is drawn by hand; more corners than this is a mistake.
constexpr std::size_t most_corners_of_a_section = 1000;

/// Names stand in paths, in lists with commas and in tables.
void check_name(const std::string& name, const std::string& at, FaultList& faults) {
  if (name.find_first_of("/\\,<>\"") != std::string::npos || name.starts_with('.')) {
    faults.add(at, "is \"" + name + "\", must not hold / \\ , < > \" or start with a dot");
  }
}

/// Names that lay-out gives by itself: S and at least three digits.
bool is_given_name(const std::string& name) {
  return name.size() >= 4 && name[0] == 'S' &&
         name.find_first_not_of("0123456789", 1) == std::string::npos;
}

NamedLine read_named_line(const json& value, const std::string& at, FaultList& faults) {
  NamedLine line;
  ObjectReader reader(value, at, faults);
  line.name = reader.text("name", 100);
  check_name(line.name, reader.at("name"), faults);
  if (const json* v = reader.require("line")) {
    line.line = read_map_line(*v, reader.at("line"), most_corners_of_a_section, faults);
  }
  if (const json* v = reader.find("crest")) {
    line.crest = read_map_point(*v, reader.at("crest"), faults);
  }
  if (const json* v = reader.find("toe")) {
    line.toe = read_map_point(*v, reader.at("toe"), faults);
  }
  reader.refuse_unknown();
  return line;
}

SectionsAlong read_along(const json& value, const std::string& at, std::size_t most_points,
                         FaultList& faults) {
  SectionsAlong along;
  ObjectReader reader(value, at, faults);
  if (const json* v = reader.require("along")) {
    along.along = read_map_line(*v, reader.at("along"), most_points, faults);
  }
  along.spacing_m = reader.number("spacing_m");
  along.upslope_m = reader.number("upslope_m");
  along.downslope_m = reader.number("downslope_m");
  const auto check = [&](const char* key, double v, bool right, const char* range) {
    if (!std::isnan(v)) faults.within(reader.at(key), v, right, range);
  };
  check("spacing_m", along.spacing_m, along.spacing_m > 0, "greater than 0 m");
  check("upslope_m", along.upslope_m, along.upslope_m >= 0, "at least 0 m");
  check("downslope_m", along.downslope_m, along.downslope_m >= 0, "at least 0 m");
  if (along.upslope_m == 0 && along.downslope_m == 0) {
    faults.add(at, "has upslope_m and downslope_m 0: the sections would have no length");
  }
  reader.refuse_unknown();
  return along;
}

void check_count(const SectionLayout& layout, const std::string& at, std::size_t most,
                 FaultList& faults) {
  auto count = double(layout.lines.size());
  for (const SectionsAlong& a : layout.along) {
    if (a.spacing_m > 0) count += std::floor(length_of(a.along) / a.spacing_m) + 1;
  }
  if (count <= double(most)) return;
  faults.add(at, fmt::format("asks for about {} sections, must be at most {}: take a larger "
                             "spacing or several jobs",
                             show(count), most));
}

void check_names(const SectionLayout& layout, const std::vector<std::size_t>& places,
                 const std::string& at, FaultList& faults) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < layout.lines.size(); ++i) {
    const std::string& name = layout.lines[i].name;
    const std::string name_at = fmt::format("{}/{}/name", at, places[i]);
    if (!name.empty() && !seen.insert(name).second) {
      faults.add(name_at, "is \"" + name + "\", which another section has already");
    }
    if (!layout.along.empty() && is_given_name(name)) {
      faults.add(name_at,
                 "is \"" + name + "\": S with digits is how sections laid along a line are named");
    }
  }
}

}  // namespace

SectionLayout read_sections(const json& value, const std::string& at, const RegionLimits& limits,
                            FaultList& faults) {
  SectionLayout layout;
  if (value.is_object()) {
    layout.along.push_back(read_along(value, at, limits.most_line_points, faults));
    check_count(layout, at, limits.most_sections, faults);
    return layout;
  }
  if (!value.is_array() || value.empty()) {
    faults.add(at, (value.is_array() ? "is an empty list" : "is " + kind_of(value)) +
                       std::string(", must be a list of {\"name\", \"line\"} or {\"along\", "
                                   "\"spacing_m\", \"upslope_m\", \"downslope_m\"}"));
    return layout;
  }
  if (value.size() > limits.most_sections) {
    faults.add(at, fmt::format("has {} items, must have at most {}: send several jobs",
                               value.size(), limits.most_sections));
    return layout;
  }
  std::vector<std::size_t> places;  // of the named lines in the list
  std::size_t points_left = limits.most_line_points;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::string item = fmt::format("{}/{}", at, i);
    if (value[i].is_object() && value[i].contains("along")) {
      layout.along.push_back(read_along(value[i], item, points_left, faults));
      points_left -= layout.along.back().along.size();
    } else {
      layout.lines.push_back(read_named_line(value[i], item, faults));
      places.push_back(i);
    }
  }
  check_names(layout, places, at, faults);
  check_count(layout, at, limits.most_sections, faults);
  return layout;
}

}  // namespace leda::server
