#include "profiles/sections_along.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "profiles/map_geometry.hpp"

namespace leda::profiles {
namespace {

constexpr double clear_difference_m = 0.5;
constexpr int steps_per_spacing = 20;
constexpr std::size_t most_steps = 200'000;

struct Station {
  double along = 0;
  MapPoint origin;
  MapPoint left;  // unit vector to the left of the line
};

std::vector<Station> stations_of(const MapLine& line, double spacing) {
  const double length = length_of(line);
  const double reach = std::min(spacing / 2, length / 2);
  std::vector<Station> stations;
  const auto count = static_cast<std::size_t>(count_along(length, spacing));
  for (std::size_t i = 0; i < count; ++i) {
    const double along = count == 1 ? length / 2 : spacing * (0.5 + static_cast<double>(i));
    const MapPoint before = point_at(line, along - reach), after = point_at(line, along + reach);
    const double chord = distance(before, after);
    if (chord == 0) continue;
    const MapPoint left{-(after.y - before.y) / chord, (after.x - before.x) / chord};
    stations.push_back({along, point_at(line, along), left});
  }
  return stations;
}

MapPoint beside(const Station& station, double to_the_left) {
  return {station.origin.x + to_the_left * station.left.x,
          station.origin.y + to_the_left * station.left.y};
}

// Mean ground elevation on one side (+1 left, -1 right), m; nothing where there is hardly any data.
std::optional<double> mean_elevation(const Station& station, double side, double reach,
                                     const Dem& dem) {
  constexpr int samples = 50;
  double sum = 0;
  int count = 0;
  for (int i = 1; i <= samples; ++i) {
    if (const auto z = dem.sample(beside(station, side * reach * i / samples))) {
      sum += *z;
      ++count;
    }
  }
  if (count < samples / 5) return std::nullopt;
  return sum / count;
}

// +1 where the left is clearly higher, -1 where the right is, 0 where that is unclear.
int uphill_side(const Station& station, double reach, const Dem& dem) {
  const auto left = mean_elevation(station, 1, reach, dem);
  const auto right = mean_elevation(station, -1, reach, dem);
  if (!left || !right) return left ? 1 : right ? -1 : 0;
  if (std::abs(*left - *right) < clear_difference_m) return 0;
  return *left > *right ? 1 : -1;
}

std::vector<int> uphill_sides(const std::vector<Station>& stations, double reach, const Dem& dem) {
  std::vector<int> clear;
  clear.reserve(stations.size());
  for (const Station& station : stations) clear.push_back(uphill_side(station, reach, dem));
  std::vector<int> sides = clear;
  const auto count = static_cast<std::ptrdiff_t>(clear.size());
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    int& side = sides[static_cast<std::size_t>(i)];
    for (std::ptrdiff_t away = 1; side == 0 && away < count; ++away) {
      if (i >= away) side = clear[static_cast<std::size_t>(i - away)];
      if (side == 0 && i + away < count) side = clear[static_cast<std::size_t>(i + away)];
    }
    if (side == 0) side = 1;
  }
  return sides;
}

}  // namespace

double count_along(double length, double spacing) {
  return std::max(1.0, std::floor(length / spacing + 0.5));
}

MapLine smoothed(const MapLine& line, double spacing) {
  const double length = length_of(line);
  const auto steps = std::clamp<std::size_t>(
      static_cast<std::size_t>(std::ceil(length / spacing * steps_per_spacing)), 2, most_steps);
  // Prefix sums of evenly spaced points: every mean costs two look-ups.
  std::vector<MapPoint> sums{{0, 0}};
  MapLine even;
  std::size_t segment = 1;
  double passed = 0;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double along = length * static_cast<double>(i) / static_cast<double>(steps);
    while (segment + 1 < line.size() &&
           passed + distance(line[segment - 1], line[segment]) < along) {
      passed += distance(line[segment - 1], line[segment]);
      ++segment;
    }
    even.push_back(point_at({line[segment - 1], line[segment]}, along - passed));
    sums.push_back({sums.back().x + even.back().x, sums.back().y + even.back().y});
  }
  MapLine result;
  for (std::size_t i = 0; i <= steps; ++i) {
    const std::size_t half = std::min({static_cast<std::size_t>(steps_per_spacing), i, steps - i});
    const auto count = static_cast<double>(2 * half + 1);
    const MapPoint& from = sums[i - half];
    const MapPoint& to = sums[i + half + 1];
    result.push_back({(to.x - from.x) / count, (to.y - from.y) / count});
  }
  return result;
}

std::vector<LaidSection> lay_along(const SectionsAlong& along, int line_index, int first,
                                   const Dem& dem) {
  const double unit = dem.info().metres_per_unit;
  const double spacing = along.spacing_m / unit;
  const double upslope = along.upslope_m / unit, downslope = along.downslope_m / unit;
  const std::vector<Station> stations = stations_of(smoothed(along.along, spacing), spacing);
  const std::vector<int> sides = uphill_sides(stations, upslope, dem);
  std::vector<LaidSection> sections;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    LaidSection section;
    section.name = fmt::format("S{:03}", first + static_cast<int>(i));
    section.line = line_index;
    section.order = stations[i].along * unit;
    section.trace = {beside(stations[i], sides[i] * upslope),
                     beside(stations[i], -sides[i] * downslope)};
    sections.push_back(std::move(section));
  }
  return sections;
}

}  // namespace leda::profiles
