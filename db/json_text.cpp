#include "db/json_text.hpp"

#include <limits>
#include <nlohmann/json.hpp>

#include "db/store.hpp"

namespace leda::db {

namespace {

using nlohmann::json;

std::string text_of(const json& value) {
  // Text from a crashed worker may not be UTF-8: a replacement mark loses less than an exception.
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

/// What `convert` makes of the parsed text; text that is not as it was written is a StoreError.
template <class Convert>
auto read(const std::string& text, Convert convert) {
  try {
    return convert(json::parse(text));
  } catch (const json::exception& error) {
    throw StoreError(std::string("the store holds damaged JSON text: ") + error.what());
  }
}

double number(const json& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

json ring_to_json(const MapLine& line) {
  json points = json::array();
  for (const MapPoint& p : line) points.push_back({p.x, p.y});
  return points;
}

MapLine ring_from_json(const json& points) {
  MapLine line;
  line.reserve(points.size());
  for (const json& p : points) line.push_back({number(p.at(0)), number(p.at(1))});
  return line;
}

}  // namespace

std::string to_json(const Polyline& line) {
  json points = json::array();
  for (const Point& p : line) points.push_back({p.x, p.z});
  return text_of(points);
}

std::string to_json(const MapLine& line) { return text_of(ring_to_json(line)); }

std::string to_json(const std::vector<MapPolygon>& area) {
  json polygons = json::array();
  for (const MapPolygon& polygon : area) {
    json rings = json::array({ring_to_json(polygon.outer)});
    for (const MapLine& hole : polygon.holes) rings.push_back(ring_to_json(hole));
    polygons.push_back(std::move(rings));
  }
  return text_of(polygons);
}

std::string to_json(const std::vector<std::string>& words) { return text_of(json(words)); }

Polyline polyline_from_json(const std::string& text) {
  Polyline line;
  for (const MapPoint& p : map_line_from_json(text)) line.push_back({p.x, p.y});
  return line;
}

MapLine map_line_from_json(const std::string& text) { return read(text, ring_from_json); }

std::vector<MapPolygon> area_from_json(const std::string& text) {
  return read(text, [](const json& polygons) {
    std::vector<MapPolygon> area;
    for (const json& rings : polygons) {
      MapPolygon polygon{ring_from_json(rings.at(0)), {}};
      for (std::size_t i = 1; i < rings.size(); ++i)
        polygon.holes.push_back(ring_from_json(rings[i]));
      area.push_back(std::move(polygon));
    }
    return area;
  });
}

std::vector<std::string> words_from_json(const std::string& text) {
  return read(text, [](const json& words) { return words.get<std::vector<std::string>>(); });
}

}  // namespace leda::db
