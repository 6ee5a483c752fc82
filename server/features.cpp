#include "server/features.hpp"

#include <algorithm>
#include <limits>

#include "profiles/export_layers.hpp"
#include "server/region_layers.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using profiles::ToCrs84;

json points(const MapLine& line) {
  json list = json::array();
  for (const MapPoint& p : line) list.push_back({p.x, p.y});
  return list;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const auto& part : parts) text += (text.empty() ? "" : "; ") + part;
  return text;
}

template <class T>
json or_null(const std::optional<T>& value) {
  return value ? json(*value) : json();
}

json section_as_feature(const db::SectionRecord& record, const db::JobRecord& job,
                        const ToCrs84& to_crs84) {
  const auto section = section_feature(record);
  json properties = {{"job", job.id},
                     {"region", job.name},
                     {"name", section.name},
                     {"line", section.line},
                     {"order_m", section.order},
                     {"status", section.status},
                     {"reason", section.reason},
                     {"retrogression_m", or_null(section.retrogression_m)},
                     {"runout_m", or_null(section.runout_m)},
                     {"runout_from_crest_m", or_null(section.runout_from_crest_m)},
                     {"slides", or_null(section.slides)},
                     {"run_time_s", or_null(section.run_time_s)},
                     {"warnings", joined(section.warnings)},
                     {"made_by", section.made_by}};
  return {{"type", "Feature"},
          {"id", record.id},
          {"geometry", {{"type", "LineString"}, {"coordinates", points(to_crs84(section.trace))}}},
          {"properties", properties}};
}

json zone_as_feature(const db::ZoneRecord& record, const db::JobRecord& job,
                     const ToCrs84& to_crs84) {
  const Zone& zone = record.zone;
  json polygons = json::array();
  for (const MapPolygon& native : zone.area) {
    const MapPolygon polygon = to_crs84(native);
    json rings = json::array({points(polygon.outer)});
    for (const MapLine& hole : polygon.holes) rings.push_back(points(hole));
    polygons.push_back(rings);
  }
  return {{"type", "Feature"},
          {"id", record.id},
          {"geometry", {{"type", "MultiPolygon"}, {"coordinates", polygons}}},
          {"properties",
           {{"job", job.id},
            {"region", job.name},
            {"sections", joined(zone.sections)},
            {"largest_distance_m", zone.largest_distance_m},
            {"mean_distance_m", zone.mean_distance_m},
            {"warnings", joined(zone.warnings)},
            {"made_by", zone.made_by}}}};
}

void grow(std::array<double, 4>& box, const json& coordinates) {
  if (!coordinates.empty() && coordinates[0].is_number()) {
    const double x = coordinates[0].get<double>();
    const double y = coordinates[1].get<double>();
    box = {std::min(box[0], x), std::min(box[1], y), std::max(box[2], x), std::max(box[3], y)};
    return;
  }
  for (const auto& part : coordinates) grow(box, part);
}

}  // namespace

const char* to_string(Collection collection) {
  switch (collection) {
    case Collection::sections:
      return "sections";
    case Collection::release_zones:
      return "release_zones";
    case Collection::runout_zones:
      return "runout_zones";
  }
  return "";
}

std::optional<Collection> collection_from(const std::string& id) {
  for (const Collection collection : all_collections) {
    if (id == to_string(collection)) return collection;
  }
  return std::nullopt;
}

std::vector<json> features_of(const db::Store& store, const db::JobRecord& job,
                              Collection collection) {
  const ToCrs84 to_crs84(epsg_of(store, job));
  std::vector<json> features;
  if (collection == Collection::sections) {
    for (const auto& section : store.sections(job.id)) {
      features.push_back(section_as_feature(section, job, to_crs84));
    }
    return features;
  }
  const ZoneKind kind =
      collection == Collection::release_zones ? ZoneKind::release : ZoneKind::runout;
  for (const auto& zone : store.zones(job.id)) {
    if (zone.zone.kind == kind) features.push_back(zone_as_feature(zone, job, to_crs84));
  }
  return features;
}

std::array<double, 4> box_of(const json& feature) {
  constexpr double far = std::numeric_limits<double>::infinity();
  std::array<double, 4> box{far, far, -far, -far};
  grow(box, feature["geometry"]["coordinates"]);
  return box;
}

json feature_collection(const std::vector<json>& features) {
  return {{"type", "FeatureCollection"}, {"features", features}};
}

}  // namespace leda::server
