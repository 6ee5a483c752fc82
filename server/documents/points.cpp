#include "server/documents/points.hpp"

#include <nlohmann/json.hpp>

namespace leda::server {

using nlohmann::json;

json points(const MapLine& line, Rounding rounded) {
  json list = json::array();
  for (const MapPoint& p : line) list.push_back({rounded(p.x), rounded(p.y)});
  return list;
}

json points(const Polyline& line) {
  json list = json::array();
  for (const Point& p : line) list.push_back({p.x, p.z});
  return list;
}

}  // namespace leda::server
