#include "profiles/map_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace leda::profiles {
namespace {

MapPoint between(MapPoint a, MapPoint b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

double cross(MapPoint o, MapPoint a, MapPoint b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

bool boxes_meet(MapPoint a, MapPoint b, MapPoint c, MapPoint d) {
  return std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) &&
         std::max(a.y, b.y) >= std::min(c.y, d.y) && std::max(c.y, d.y) >= std::min(a.y, b.y);
}

std::optional<MapPoint> crossing(MapPoint a, MapPoint b, MapPoint c, MapPoint d) {
  if (!boxes_meet(a, b, c, d)) return std::nullopt;
  const double c_side = cross(a, b, c), d_side = cross(a, b, d);
  if (c_side * d_side > 0 || cross(c, d, a) * cross(c, d, b) > 0) return std::nullopt;
  if (c_side == d_side) return c;  // on one line, overlapping
  return between(c, d, c_side / (c_side - d_side));
}

bool is_inside_ring(const MapLine& ring, MapPoint p) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const MapPoint a = ring[i], b = ring[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
      inside = !inside;
    }
  }
  return inside;
}

// Turning straight back over the segment before.
bool doubles_back(MapPoint a, MapPoint b, MapPoint c) {
  const double forward = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
  return cross(a, b, c) == 0 && forward < 0;
}

}  // namespace

double distance(MapPoint a, MapPoint b) { return std::hypot(b.x - a.x, b.y - a.y); }

double length_of(const MapLine& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
  return length;
}

MapPoint point_at(const MapLine& line, double along) {
  if (along <= 0) return line.front();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step = distance(line[i - 1], line[i]);
    if (along <= step && step > 0) return between(line[i - 1], line[i], along / step);
    along -= step;
  }
  return line.back();
}

MapLine piece_of(const MapLine& line, double from, double to) {
  MapLine piece{point_at(line, from)};
  double along = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    along += distance(line[i - 1], line[i]);
    if (along > from && along < to) piece.push_back(line[i]);
  }
  piece.push_back(point_at(line, to));
  return piece;
}

Nearest nearest_on(const MapLine& line, MapPoint p) {
  Nearest nearest{0, distance(line.front(), p)};
  double along = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const MapPoint a = line[i - 1], b = line[i];
    const double step = distance(a, b);
    if (step == 0) continue;
    const double share = std::clamp(
        ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / (step * step), 0.0, 1.0);
    const double away = distance(p, between(a, b, share));
    if (away < nearest.distance) nearest = {along + share * step, away};
    along += step;
  }
  return nearest;
}

std::optional<MapPoint> first_self_crossing(const MapLine& line) {
  const bool closed = line.size() > 3 && line.front() == line.back();
  for (std::size_t j = 1; j + 1 < line.size(); ++j) {
    if (doubles_back(line[j - 1], line[j], line[j + 1])) return line[j];
    for (std::size_t i = 0; i + 1 < j; ++i) {
      if (closed && i == 0 && j + 2 == line.size()) continue;
      if (const auto p = crossing(line[i], line[i + 1], line[j], line[j + 1])) return p;
    }
  }
  return std::nullopt;
}

Bend greatest_bend(const MapLine& line) {
  const MapPoint way{line.back().x - line.front().x, line.back().y - line.front().y};
  const double least = 0.01 * length_of(line);
  Bend greatest{0, line.front()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const MapPoint piece{line[i].x - line[i - 1].x, line[i].y - line[i - 1].y};
    if (std::hypot(piece.x, piece.y) < least) continue;
    const double aside = way.x * piece.y - way.y * piece.x;
    const double ahead = way.x * piece.x + way.y * piece.y;
    const double degrees = std::abs(std::atan2(aside, ahead)) * 180 / std::numbers::pi;
    if (degrees > greatest.degrees) greatest = {degrees, line[i - 1]};
  }
  return greatest;
}

bool is_inside(const MapPolygon& polygon, MapPoint p) {
  if (polygon.outer.empty() || !is_inside_ring(polygon.outer, p)) return false;
  return std::none_of(polygon.holes.begin(), polygon.holes.end(), [&](const MapLine& hole) {
    return !hole.empty() && is_inside_ring(hole, p);
  });
}

}  // namespace leda::profiles
