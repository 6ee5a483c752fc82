#include "server/documents/map_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace leda::server {
namespace {

using nlohmann::json;

double side_of(MapPoint a, MapPoint b, MapPoint p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

bool is_in_box(MapPoint a, MapPoint b, MapPoint p) {
  return p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
         p.y <= std::max(a.y, b.y);
}

bool boxes_overlap(MapPoint a, MapPoint b, MapPoint c, MapPoint d) {
  return std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) &&
         std::max(a.y, b.y) >= std::min(c.y, d.y) && std::max(c.y, d.y) >= std::min(a.y, b.y);
}

bool meet(MapPoint a, MapPoint b, MapPoint c, MapPoint d) {
  if (!boxes_overlap(a, b, c, d)) return false;
  const double c_side = side_of(a, b, c), d_side = side_of(a, b, d);
  const double a_side = side_of(c, d, a), b_side = side_of(c, d, b);
  if (c_side * d_side < 0 && a_side * b_side < 0) return true;
  return (c_side == 0 && is_in_box(a, b, c)) || (d_side == 0 && is_in_box(a, b, d)) ||
         (a_side == 0 && is_in_box(c, d, a)) || (b_side == 0 && is_in_box(c, d, b));
}

bool turns_back(MapPoint a, MapPoint b, MapPoint c) {
  const double along = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
  return side_of(a, b, c) == 0 && along < 0;
}

/// The first two edges that meet beside their common corner. @param line closed if first == last
std::optional<std::pair<std::size_t, std::size_t>> first_crossing(const MapLine& line) {
  const std::size_t edges = line.size() - 1;
  const bool closed = line.front() == line.back();
  for (std::size_t i = 0; i < edges; ++i) {
    if (i + 1 < edges && turns_back(line[i], line[i + 1], line[i + 2])) return {{i, i + 1}};
    for (std::size_t j = i + 2; j < edges; ++j) {
      if (closed && i == 0 && j == edges - 1) continue;
      if (meet(line[i], line[i + 1], line[j], line[j + 1])) return {{i, j}};
    }
  }
  return std::nullopt;
}

bool is_line_of_lines(const json& value) {
  const json& first = value[0];
  return first.is_array() && !first.empty() && first[0].is_array();
}

/// Points so close that they are one, and that make an edge meet its neighbour's neighbour.
bool is_nearly_repeated(MapPoint a, MapPoint b) {
  constexpr double least_apart = 1e-3;  // units of the CRS
  return std::hypot(b.x - a.x, b.y - a.y) < least_apart;
}

/// The points, or nothing where one of them is at fault.
std::optional<MapLine> read_points(const json& value, const std::string& at, std::size_t least,
                                   std::size_t most, FaultList& faults) {
  if (!value.is_array() || value.size() < least || value.size() > most) {
    faults.add(at, fmt::format("{}, must be a list of {} to {} points [x, y]",
                               value.is_array() ? fmt::format("has {} points", value.size())
                                                : "is " + kind_of(value),
                               least, most) +
                       (value.is_object() && value.contains("coordinates")
                            ? ": of a GeoJSON geometry its coordinates alone"
                            : ""));
    return std::nullopt;
  }
  if (is_line_of_lines(value)) {
    faults.add(at, fmt::format("is a list of {} lines (a MultiLineString or a polygon with its "
                               "rings), must be one line: a list of points [x, y]",
                               value.size()));
    return std::nullopt;
  }
  MapLine line;
  bool sound = true;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const auto point = read_map_point(value[i], fmt::format("{}/{}", at, i), faults);
    sound = sound && point;
    if (!sound) continue;
    if (!line.empty() && line.back() == *point) {
      faults.add(fmt::format("{}/{}", at, i), "repeats the point before it");
      sound = false;
      continue;
    }
    if (!line.empty() && is_nearly_repeated(line.back(), *point)) {
      faults.add(fmt::format("{}/{}", at, i),
                 fmt::format("({}, {}) lies {:.2g} from the point before it: leave one of them out",
                             show(point->x), show(point->y),
                             std::hypot(point->x - line.back().x, point->y - line.back().y)));
      sound = false;
      continue;
    }
    line.push_back(*point);
  }
  if (!sound) return std::nullopt;
  return line;
}

void check_crossing(const MapLine& line, const std::string& at, FaultList& faults) {
  if (const auto crossing = first_crossing(line)) {
    faults.add(at, fmt::format("crosses itself: the edge from point {} meets the edge from point "
                               "{}, which starts at ({}, {})",
                               crossing->first, crossing->second, show(line[crossing->second].x),
                               show(line[crossing->second].y)));
  }
}

}  // namespace

std::optional<MapPoint> read_map_point(const json& value, const std::string& at,
                                       FaultList& faults) {
  const auto pair = read_pair(value, at, "a point [x, y]", faults);
  if (!pair || std::isnan((*pair)[0]) || std::isnan((*pair)[1])) return std::nullopt;
  return MapPoint{(*pair)[0], (*pair)[1]};
}

MapLine read_map_line(const json& value, const std::string& at, std::size_t most_points,
                      FaultList& faults) {
  const auto line = read_points(value, at, 2, most_points, faults);
  if (!line) return {};
  check_crossing(*line, at, faults);
  return *line;
}

MapPolygon read_map_polygon(const json& value, const std::string& at, std::size_t most_points,
                            FaultList& faults) {
  auto ring = read_points(value, at, 3, most_points, faults);
  if (!ring) return {};
  if (!(ring->front() == ring->back())) ring->push_back(ring->front());
  if (ring->size() < 4) {
    faults.add(at, "has 2 corners, must have at least 3");
    return {};
  }
  check_crossing(*ring, at, faults);
  return {std::move(*ring), {}};
}

double length_of(const MapLine& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    length += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
  }
  return length;
}

}  // namespace leda::server
