#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "server/http/handlers/datetime.hpp"
#include "server/http/handlers/handlers.hpp"
#include "server/http/handlers/parameters.hpp"
#include "server/http/site.hpp"
#include "server/layers/features.hpp"
#include "server/layers/region_layers.hpp"
#include "server/operate/problem.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

constexpr const char* crs84 = "http://www.opengis.net/def/crs/OGC/1.3/CRS84";

Collection collection_or_problem(const std::string& id) {
  const auto collection = collection_from(id);
  if (!collection) {
    throw Problem(Failure::no_such_resource,
                  "there is no collection '" + id +
                      "': known are sections, release_zones, runout_zones and "
                      "probability_zones");
  }
  return *collection;
}

constexpr double whole_turn = 360;

/// A longitude between -180 and 180.
double on_the_globe(double degrees) {
  return std::abs(degrees) <= whole_turn / 2 ? degrees : std::remainder(degrees, whole_turn);
}

/// A map that is panned over 180 degrees counts on beyond: its box then crosses them, west being
/// greater than east. One that shows more than the world shows all of it.
MapBox on_the_globe(const MapBox& box) {
  const auto& [west, south, east, north] = box;
  if (east - west >= whole_turn) return {-whole_turn / 2, south, whole_turn / 2, north};
  return {on_the_globe(west), south, on_the_globe(east), north};
}

/// bbox=west,south,east,north in degrees, or the same with two heights, which say nothing here.
std::optional<MapBox> wanted_box(const Call& call) {
  if (!call.parameter("bbox")) return std::nullopt;
  const auto parts = list(call, "bbox");
  std::vector<double> numbers;
  bool sound = parts.size() == 4 || parts.size() == 6;
  for (const auto& part : parts) {
    double number = 0;
    const char* last = part.data() + part.size();
    const auto [end, error] = std::from_chars(part.data(), last, number);
    sound = sound && error == std::errc{} && end == last && std::isfinite(number);
    numbers.push_back(number);
  }
  if (sound && parts.size() == 6) numbers = {numbers[0], numbers[1], numbers[3], numbers[4]};
  // A map that shows more than the world has more degrees than there are; metres are a thousand.
  constexpr double no_degrees = 1000;
  const bool in_metres =
      std::ranges::any_of(numbers, [](double number) { return std::abs(number) > no_degrees; });
  if (!sound || in_metres || numbers[1] > numbers[3]) {
    throw Problem(Failure::invalid_parameter,
                  "bbox is '" + *call.parameter("bbox") +
                      "': give west,south,east,north in degrees" +
                      (in_metres ? " of longitude and latitude, not coordinates of the DEM" : ""));
  }
  return on_the_globe({numbers[0], numbers[1], numbers[2], numbers[3]});
}

db::PageFilter filter_of(const Site& site, const Call& call) {
  db::PageFilter filter;
  filter.limit = whole_number(call, "limit", 100, 1, 10'000);
  filter.after = page_start(call);
  filter.box = wanted_box(call);
  interval(call);  // features have no time of their own, so that each is of any time
  if (const auto id = call.parameter("job"))
    filter.job = job_status_or_problem(site.service.store, *id).id;
  return filter;
}

/// A job that stands on no DEM has nothing on the map.
bool has_a_map(const Site& site, const db::PageFilter& filter) {
  return filter.job.empty() ||
         epsg_of(site.service.store, *site.service.store.job_status(filter.job)) != 0;
}

/// The CRS the coordinates are kept in, where all features share one.
std::string storage_crs(const db::Coverage& coverage) {
  if (coverage.epsg.size() != 1) return crs84;
  return "http://www.opengis.net/def/crs/EPSG/0/" + std::to_string(coverage.epsg.front());
}

json link(const std::string& href, const char* rel, const char* type) {
  return {{"href", href}, {"rel", rel}, {"type", type}};
}

const char* title_of(Collection collection) {
  switch (collection) {
    case Collection::sections:
      return "Sections";
    case Collection::release_zones:
      return "Release zones";
    case Collection::runout_zones:
      return "Runout zones";
    case Collection::probability_zones:
      break;
  }
  return "Probability zones, conditional on a slide starting at the section";
}

json collection_document(const Site& site, Collection collection) {
  const std::string own = site.url + "/collections/" + to_string(collection);
  const db::Coverage coverage = coverage_of(site.service.store, collection);
  const char* title = title_of(collection);
  const MapBox box = coverage.box.value_or(MapBox{-180, -90, 180, 90});
  return {
      {"id", to_string(collection)},
      {"title", title},
      {"description", "of all jobs that succeeded; job= selects one"},
      {"itemType", "feature"},
      {"crs", {crs84}},
      {"storageCrs", storage_crs(coverage)},
      {"extent", {{"spatial", {{"bbox", json::array({box})}, {"crs", crs84}}}}},
      {"links", json::array({link(own, "self", "application/json"),
                             link(own + "/items", "items", "application/geo+json"),
                             link(own + "/schema", "describedby", "application/schema+json")})}};
}

std::string text_of(const json& document) {
  return document.dump(-1, ' ', false, json::error_handler_t::replace);
}

Answer geojson_answer(const json& document) {
  Answer answer = json_answer(document);
  answer.type = "application/geo+json";
  return answer;
}

}  // namespace

Answer get_collections(Site& site, const Call& call) {
  format(call, {"json"});
  json collections = json::array();
  for (const Collection collection : all_collections) {
    collections.push_back(collection_document(site, collection));
  }
  return json_answer(
      {{"collections", collections},
       {"links", json::array({link(site.url + "/collections", "self", "application/json")})}});
}

Answer get_collection(Site& site, const Call& call) {
  format(call, {"json"});
  return json_answer(collection_document(site, collection_or_problem(call.captured[0])));
}

Answer get_schema(Site& /*site*/, const Call& call) {
  format(call, {"json"});
  Answer answer = json_answer(schema_of(collection_or_problem(call.captured[0])));
  answer.type = "application/schema+json";
  return answer;
}

Answer get_items(Site& site, const Call& call) {
  format(call, {"json", "geojson"});
  const Collection collection = collection_or_problem(call.captured[0]);
  db::PageFilter filter = filter_of(site, call);
  const bool any = has_a_map(site, filter);
  const int matched = any ? count_features(site.service.store, collection, filter) : 0;
  const int limit = filter.limit++;  // one more tells whether there is a next page
  Answer answer;
  answer.type = "application/geo+json";
  // Written piece by piece: a whole page as JSON takes many times as much as its text.
  answer.body = R"({"type":"FeatureCollection","features":[)";
  int found = 0;
  std::int64_t last = filter.after;
  if (any) {
    const db::Turns::Turn turn(site.pages);
    for_each_feature(site.service.store, collection, filter, [&](const json& feature) {
      if (++found > limit) return;
      answer.body += found == 1 ? "\n" : ",\n";
      answer.body += text_of(feature);
      last = feature["id"];
    });
  }
  const std::string own = site.url + "/collections/" + to_string(collection);
  json rest;
  rest["links"] = json::array(
      {link(page_after(call, own + "/items", filter.after), "self", "application/geo+json")});
  if (found > limit) {
    rest["links"].push_back(
        link(page_after(call, own + "/items", last), "next", "application/geo+json"));
  }
  rest["links"].push_back(link(own, "collection", "application/json"));
  rest["numberMatched"] = matched;
  rest["numberReturned"] = std::min(found, limit);
  rest["timeStamp"] = db::utc_now();
  answer.body += "],\n" + text_of(rest).substr(1) + "\n";
  return answer;
}

Answer get_item(Site& site, const Call& call) {
  format(call, {"json", "geojson"});
  const Collection collection = collection_or_problem(call.captured[0]);
  const std::string& text = call.captured[1];
  std::int64_t id = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  const bool is_id = error == std::errc{} && end == text.data() + text.size();
  db::PageFilter filter;
  filter.id = id;
  json found;
  if (is_id) {
    for_each_feature(site.service.store, collection, filter,
                     [&](json&& feature) { found = std::move(feature); });
  }
  if (found.is_null()) {
    throw Problem(Failure::no_such_resource,
                  "there is no feature " + text + " in " + to_string(collection));
  }
  const std::string own = site.url + "/collections/" + to_string(collection);
  found["links"] = json::array({link(own + "/items/" + text, "self", "application/geo+json"),
                                link(own, "collection", "application/json")});
  return geojson_answer(found);
}

}  // namespace leda::server
