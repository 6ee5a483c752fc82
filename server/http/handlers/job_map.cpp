#include <cmath>
#include <nlohmann/json.hpp>

#include "server/documents/points.hpp"
#include "server/http/handlers/handlers.hpp"
#include "server/http/handlers/parameters.hpp"
#include "server/http/site.hpp"
#include "server/layers/region_layers.hpp"
#include "server/layers/summary.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

/// To the millimetre: more digits only make the answer longer.
double rounded(double value) { return std::round(value * 1000) / 1000; }

/// One column a property: of ten thousand sections the names of properties would be most.
json sections_of(const db::Store& store, const db::PageFilter& page) {
  json columns;
  for (const char* name : {"name", "line", "order_m", "trace", "state", "status", "retrogression_m",
                           "retrogression_is", "runout_m", "runout_is", "run_time_s", "warnings"}) {
    columns[name] = json::array();
  }
  for (const auto& section : store.section_page(page)) {
    const auto feature = section_feature(section);
    const auto number = [](const std::optional<double>& value) {
      return value ? json(rounded(*value)) : json();
    };
    const auto text = [](const auto& value) { return value ? json(*value) : json(); };
    columns["name"].push_back(section.name);
    columns["line"].push_back(section.line < 0 ? json() : json(section.line));
    columns["order_m"].push_back(section.line < 0 ? json() : json(rounded(section.order)));
    columns["trace"].push_back(points(section.trace, rounded));
    columns["state"].push_back(db::to_string(section.state));
    columns["status"].push_back(status_of(section));
    columns["retrogression_m"].push_back(number(feature.retrogression_m));
    columns["retrogression_is"].push_back(text(feature.retrogression_is));
    columns["runout_m"].push_back(number(feature.runout_m));
    columns["runout_is"].push_back(text(feature.runout_is));
    columns["run_time_s"].push_back(number(feature.run_time_s));
    columns["warnings"].push_back(feature.warnings.size());
  }
  return columns;
}

json zone_document(const Zone& zone) {
  json polygons = json::array();
  for (const MapPolygon& polygon : zone.area) {
    json rings = json::array({points(polygon.outer, rounded)});
    for (const MapLine& hole : polygon.holes) rings.push_back(points(hole, rounded));
    polygons.push_back(std::move(rings));
  }
  json document = {{"sections", zone.sections},
                   {"largest_distance_m", rounded(zone.largest_distance_m)},
                   {"mean_distance_m", rounded(zone.mean_distance_m)},
                   {"distance_is", to_string(zone.distance_is)},
                   {"warnings", zone.warnings},
                   {"polygons", std::move(polygons)}};
  if (zone.probability) {
    document.update({{"kind", to_string(zone.kind)},
                     {"exceedance", zone.probability->exceedance},
                     {"members", zone.probability->members}});
  }
  return document;
}

json document_of(const db::Store& store, const db::JobRecord& job) {
  db::PageFilter page;
  page.job = job.id;
  page.limit = 1'000'000;  // a layout has a limit of its own
  json document = {{"job", job.id},
                   {"name", job.name},
                   {"processID", job.process},
                   {"status", db::to_string(job.state)},
                   {"message", job.message},
                   {"progress", job.progress},
                   {"dem", job.raster},
                   {"crs", "EPSG:" + std::to_string(epsg_of(store, job))},
                   {"request", json::parse(job.request, nullptr, false)},
                   {"sections", sections_of(store, page)},
                   {"release_zones", json::array()},
                   {"runout_zones", json::array()},
                   {"probability_zones", json::array()}};
  for (const auto& zone : store.zones(job.id)) {
    document[to_string(layer_of(zone.zone))].push_back(zone_document(zone.zone));
  }
  return document;
}

}  // namespace

Answer get_job_map(Site& site, const Call& call) {
  const auto job = job_or_problem(site.service.store, call.captured[0]);
  // A retry changes `updated`; what goes on may change within its millisecond.
  const bool finished = job.state != db::JobState::accepted && job.state != db::JobState::running;
  const std::string tag = "\"" + job.id + "-" + job.updated + "-map\"";
  if (finished && has_already(call, tag)) return not_modified(tag);
  const db::Turns::Turn turn(site.pages);
  Answer answer;
  answer.type = "application/vnd.leda.map+json";
  answer.body =
      document_of(site.service.store, job).dump(-1, ' ', false, json::error_handler_t::replace);
  answer.headers.emplace_back("Cache-Control", "no-cache");
  if (finished) answer.headers.emplace_back("ETag", tag);
  return answer;
}

}  // namespace leda::server
