#include "server/layers/features.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "profiles/antimeridian.hpp"
#include "profiles/export_layers.hpp"
#include "server/documents/ensemble_document.hpp"
#include "server/documents/or_null.hpp"
#include "server/documents/points.hpp"
#include "server/layers/region_layers.hpp"
#include "server/operate/logging.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using profiles::ToCrs84;

/// A millimetre on the ground; more digits only make the answers longer.
constexpr double degrees_kept = 1e8;

double rounded(double degrees) { return std::round(degrees * degrees_kept) / degrees_kept; }

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const auto& part : parts) text += (text.empty() ? "" : "; ") + part;
  return text;
}

/// What the features of one job share.
struct Ground {
  std::string job, region, dem, dem_sha256;
  ToCrs84 to_crs84;
};

Ground ground_of(const db::Store& store, const db::JobStatus& job) {
  const auto raster = store.raster(job.raster);
  return {job.id, job.name, raster ? raster->name : "", raster ? raster->sha256 : "",
          ToCrs84(raster ? raster->epsg : 0)};
}

/// Looks up each job of a page once.
class Grounds {
 public:
  explicit Grounds(const db::Store& store) : store_(store) {}

  const Ground& of(const std::string& job) {
    const auto found = known_.find(job);
    if (found != known_.end()) return found->second;
    return known_.emplace(job, ground_of(store_, store_.job_status(job).value())).first->second;
  }

 private:
  const db::Store& store_;
  std::map<std::string, Ground> known_;
};

json origin_of(const Ground& ground) {
  return {{"job", ground.job},
          {"region", ground.region},
          {"dem", ground.dem},
          {"dem_sha256", ground.dem_sha256}};
}

/// Two lines where it crosses 180 degrees.
json line_geometry(const MapLine& degrees) {
  const auto parts = profiles::cut_at_antimeridian(degrees);
  if (parts.size() == 1)
    return {{"type", "LineString"}, {"coordinates", points(parts[0], rounded)}};
  json lines = json::array();
  for (const MapLine& part : parts) lines.push_back(points(part, rounded));
  return {{"type", "MultiLineString"}, {"coordinates", lines}};
}

json section_as_feature(const db::SectionRecord& record, const Ground& ground) {
  const auto section = section_feature(record);
  json properties = origin_of(ground);
  properties.update({{"name", section.name},
                     {"line", section.line},
                     {"order_m", section.order},
                     {"status", section.status},
                     {"reason", section.reason},
                     {"decision", section.decision},
                     {"factor_of_safety", or_null(section.factor_of_safety)},
                     {"retrogression_m", or_null(section.retrogression_m)},
                     {"runout_m", or_null(section.runout_m)},
                     {"runout_from_crest_m", or_null(section.runout_from_crest_m)},
                     {"retrogression_is", or_null(section.retrogression_is)},
                     {"runout_is", or_null(section.runout_is)},
                     {"slides", or_null(section.slides)},
                     {"run_time_s", or_null(section.run_time_s)},
                     {"warnings", joined(section.warnings)},
                     {"made_by", section.made_by},
                     {"case_sha256", record.result ? record.result->case_sha256 : ""},
                     {"version", record.result ? record.result->version : ""}});
  return {{"type", "Feature"},
          {"id", record.id},
          {"geometry", line_geometry(ground.to_crs84(section.trace))},
          {"properties", properties}};
}

json zone_as_feature(const db::ZoneRecord& record, const Ground& ground) {
  const Zone& zone = record.zone;
  json polygons = json::array();
  for (const MapPolygon& native : zone.area) {
    for (const MapPolygon& polygon : profiles::cut_at_antimeridian(ground.to_crs84(native))) {
      json rings = json::array({points(polygon.outer, rounded)});
      for (const MapLine& hole : polygon.holes) rings.push_back(points(hole, rounded));
      polygons.push_back(rings);
    }
  }
  json properties = origin_of(ground);
  properties.update({{"sections", joined(zone.sections)},
                     {"largest_distance_m", zone.largest_distance_m},
                     {"mean_distance_m", zone.mean_distance_m},
                     {"distance_is", to_string(zone.distance_is)},
                     {"warnings", joined(zone.warnings)},
                     {"made_by", zone.made_by},
                     {"version", record.version}});
  if (zone.probability) {
    properties.update({{"kind", to_string(zone.kind)},
                       {"exceedance", zone.probability->exceedance},
                       {"members", zone.probability->members},
                       {"condition", ensemble_condition}});
  }
  return {{"type", "Feature"},
          {"id", record.id},
          {"geometry", {{"type", "MultiPolygon"}, {"coordinates", polygons}}},
          {"properties", properties}};
}

ZoneLayer layer_of(Collection collection) {
  if (collection == Collection::probability_zones) return ZoneLayer::probability;
  return collection == Collection::release_zones ? ZoneLayer::release : ZoneLayer::runout;
}

void add_box(std::vector<db::FeatureBox>& boxes, std::int64_t id, const MapLine& degrees) {
  if (!degrees.empty()) boxes.push_back({id, profiles::box_around(degrees)});
}

void place_sections(db::Store& store, const std::string& job, const ToCrs84& to_crs84) {
  std::vector<db::FeatureBox> boxes;
  const db::PageFilter all{.job = job, .limit = std::numeric_limits<int>::max()};
  for (const auto& section : store.section_page(all)) {
    add_box(boxes, section.id, to_crs84(section.trace));
  }
  store.set_section_boxes(boxes);
}

void place_zones(db::Store& store, const std::string& job, const ToCrs84& to_crs84) {
  std::vector<db::FeatureBox> boxes;
  for (const auto& zone : store.zones(job)) {
    MapLine outlines;
    for (const MapPolygon& polygon : zone.zone.area) {
      const MapLine outline = to_crs84(polygon.outer);
      outlines.insert(outlines.end(), outline.begin(), outline.end());
    }
    add_box(boxes, zone.id, outlines);
  }
  store.set_zone_boxes(boxes);
}

/// Leaves a job without a DEM alone.
template <class Place>
void place_or_tell(db::Store& store, const db::JobStatus& job, const Place& place) {
  const int epsg = epsg_of(store, job);
  if (epsg == 0) return;
  try {
    place(store, job.id, ToCrs84(epsg));
  } catch (const profiles::ExportError& error) {
    // A job is worth more than its place in a search by box.
    log_warning(job.id, "no boxes reason={}", in_quotes(error.what()));
  }
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
    case Collection::probability_zones:
      return "probability_zones";
  }
  return "";
}

std::optional<Collection> collection_from(const std::string& id) {
  for (const Collection collection : all_collections) {
    if (id == to_string(collection)) return collection;
  }
  return std::nullopt;
}

void for_each_feature(const db::Store& store, Collection collection, const db::PageFilter& filter,
                      const std::function<void(json&&)>& use) {
  Grounds grounds(store);
  if (collection == Collection::sections) {
    for (const auto& section : store.section_page(filter)) {
      use(section_as_feature(section, grounds.of(section.job)));
    }
    return;
  }
  for (const auto& zone : store.zone_page(layer_of(collection), filter)) {
    use(zone_as_feature(zone, grounds.of(zone.job)));
  }
}

int count_features(const db::Store& store, Collection collection, const db::PageFilter& filter) {
  return collection == Collection::sections ? store.count_sections(filter)
                                            : store.count_zones(layer_of(collection), filter);
}

db::Coverage coverage_of(const db::Store& store, Collection collection) {
  return collection == Collection::sections ? store.section_coverage()
                                            : store.zone_coverage(layer_of(collection));
}

json schema_of(Collection collection) {
  const auto property = [](const char* type, const char* title) {
    return json{{"type", type}, {"title", title}};
  };
  json properties = {{"job", property("string", "id of the job")},
                     {"region", property("string", "name of the job")},
                     {"dem", property("string", "name of the DEM")},
                     {"dem_sha256", property("string", "SHA-256 of the DEM's file")},
                     {"warnings", property("string", "what to know before it is used")},
                     {"made_by", property("string", "hashes of what made it")},
                     {"version", property("string", "of Leda")}};
  if (collection == Collection::sections) {
    properties.update({{"name", property("string", "name within the job")},
                       {"line", property("integer", "line it was laid along; -1: named")},
                       {"order_m", property("number", "position along that line, m")},
                       {"status", property("string", "of the run, or why there is none")},
                       {"reason", property("string", "of the status")},
                       {"decision", property("string", "of screening")},
                       {"factor_of_safety", property("number", "undrained, Bishop")},
                       {"retrogression_m", property("number", "crest to crest, m")},
                       {"runout_m", property("number", "from the toe, m")},
                       {"runout_from_crest_m", property("number", "from the crest, m")},
                       {"retrogression_is", property("string", "measured or lower-bound")},
                       {"runout_is", property("string", "measured or lower-bound")},
                       {"slides", property("integer", "counted by the documented rule")},
                       {"run_time_s", property("number", "of the simulation, s")},
                       {"case_sha256", property("string", "SHA-256 of the case")}});
  } else {
    properties.update({{"sections", property("string", "whose results made it")},
                       {"largest_distance_m", property("number", "retrogression or runout, m")},
                       {"mean_distance_m", property("number", "retrogression or runout, m")},
                       {"distance_is", property("string", "measured or lower-bound")}});
  }
  if (collection == Collection::probability_zones) {
    properties.update(
        {{"kind", property("string", "release or runout")},
         {"exceedance", property("number", "probability that the zone's edge is passed")},
         {"members", property("integer", "fewest of one of its sections")},
         {"condition", property("string", "what the probability is conditional on")}});
  }
  return {{"$schema", "http://json-schema.org/draft-07/schema#"},
          {"title", to_string(collection)},
          {"type", "object"},
          {"properties", properties}};
}

void keep_section_boxes(db::Store& store, const db::JobStatus& job) {
  place_or_tell(store, job, place_sections);
}

void keep_zone_boxes(db::Store& store, const db::JobStatus& job) {
  place_or_tell(store, job, place_zones);
}

}  // namespace leda::server
