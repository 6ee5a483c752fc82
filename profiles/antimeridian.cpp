#include "profiles/antimeridian.hpp"

#include <algorithm>
#include <cmath>

#include "profiles/areas.hpp"
#include "profiles/gdal_error.hpp"

namespace leda::profiles {
namespace {

bool within_the_world(const MapLine& line) {
  return std::ranges::all_of(line, [](const MapPoint& p) { return std::abs(p.x) <= 180; });
}

MapLine shifted(MapLine line, double degrees) {
  for (MapPoint& p : line) p.x += degrees;
  return line;
}

double signed_area(const MapLine& ring) {
  double twice = 0;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    twice += (ring[i - 1].x - ring[0].x) * (ring[i].y - ring[0].y) -
             (ring[i].x - ring[0].x) * (ring[i - 1].y - ring[0].y);
  }
  return twice;
}

MapLine turning_as(MapLine ring, const MapLine& other) {
  if ((signed_area(ring) > 0) != (signed_area(other) > 0)) std::ranges::reverse(ring);
  return ring;
}

/// What of an area lies between two meridians 360 degrees apart, moved onto the world.
void add_world(const MapPolygon& area, double turn, std::vector<MapPolygon>& parts) {
  const double west = turn - 180, east = turn + 180;
  const GeometryHandle world =
      to_ogr(MapPolygon{{{west, -90}, {east, -90}, {east, 90}, {west, 90}, {west, -90}}, {}});
  const GeometryHandle here(to_ogr(area)->Intersection(world.get()));
  if (!here) return;
  for (MapPolygon& part : polygons_of(*here)) {
    part.outer = turning_as(shifted(std::move(part.outer), -turn), area.outer);
    for (MapLine& hole : part.holes) {
      hole = shifted(std::move(hole), -turn);
      if (!area.holes.empty()) hole = turning_as(std::move(hole), area.holes.front());
    }
    parts.push_back(std::move(part));
  }
}

}  // namespace

MapLine unwrapped(MapLine degrees) {
  double turn = 0;
  for (std::size_t i = 1; i < degrees.size(); ++i) {
    const double step = degrees[i].x + turn - degrees[i - 1].x;
    if (step > 180) turn -= 360;
    if (step < -180) turn += 360;
    degrees[i].x += turn;
  }
  return degrees;
}

std::vector<MapLine> cut_at_antimeridian(const MapLine& degrees) {
  std::vector<MapLine> parts{{degrees.front()}};
  for (std::size_t i = 1; i < degrees.size(); ++i) {
    const MapPoint a = degrees[i - 1], b = degrees[i];
    if (std::abs(b.x - a.x) > 180) {
      const double edge = a.x > 0 ? 180 : -180;
      const double reach = b.x + 2 * edge - a.x;
      const double latitude = reach == 0 ? a.y : a.y + (b.y - a.y) * (edge - a.x) / reach;
      parts.back().push_back({edge, latitude});
      parts.push_back({{-edge, latitude}});
    }
    parts.back().push_back(b);
  }
  return parts;
}

std::vector<MapPolygon> cut_at_antimeridian(const MapPolygon& degrees) {
  MapPolygon whole{unwrapped(degrees.outer), {}};
  if (within_the_world(whole.outer)) return {degrees};
  const QuietGdal quiet;
  const double middle = whole.outer.front().x;
  for (const MapLine& hole : degrees.holes) {
    const MapLine one = unwrapped(hole);
    whole.holes.push_back(shifted(one, 360 * std::round((middle - one.front().x) / 360)));
  }
  std::vector<MapPolygon> parts;
  for (const double turn : {-360.0, 0.0, 360.0}) add_world(whole, turn, parts);
  return parts;
}

MapBox box_around(const MapLine& degrees) {
  const MapLine line = unwrapped(degrees);
  const auto [west, east] = std::ranges::minmax(line, {}, &MapPoint::x);
  const auto [south, north] = std::ranges::minmax(line, {}, &MapPoint::y);
  const auto on_the_world = [](double x) { return x > 180 ? x - 360 : x < -180 ? x + 360 : x; };
  return {on_the_world(west.x), south.y, on_the_world(east.x), north.y};
}

}  // namespace leda::profiles
