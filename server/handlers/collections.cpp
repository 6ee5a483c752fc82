#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "server/features.hpp"
#include "server/handlers/handlers.hpp"
#include "server/handlers/parameters.hpp"
#include "server/problem.hpp"
#include "server/region_layers.hpp"
#include "server/service.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

constexpr const char* crs84 = "http://www.opengis.net/def/crs/OGC/1.3/CRS84";
constexpr int most_jobs = 10'000;

Collection collection_or_problem(const std::string& id) {
  const auto collection = collection_from(id);
  if (!collection) {
    throw Problem(
        Failure::no_such_resource,
        "there is no collection '" + id + "': known are sections, release_zones and runout_zones");
  }
  return *collection;
}

/// Jobs whose features are shown: one, or all that succeeded.
std::vector<db::JobRecord> shown_jobs(const Service& service, const Call& call) {
  if (const auto id = call.parameter("job")) {
    auto job = job_or_problem(service.store, *id);
    if (epsg_of(service.store, job) == 0) return {};
    return {job};
  }
  db::JobFilter filter;
  filter.states = {db::JobState::successful};
  filter.limit = most_jobs;
  auto jobs = service.store.jobs(filter);
  std::erase_if(jobs, [&](const auto& job) { return epsg_of(service.store, job) == 0; });
  return jobs;
}

std::vector<json> all_features(const Service& service, const Call& call, Collection collection) {
  std::vector<json> features;
  for (const auto& job : shown_jobs(service, call)) {
    for (auto& feature : features_of(service.store, job, collection)) {
      features.push_back(std::move(feature));
    }
  }
  return features;
}

/// bbox=west,south,east,north in degrees.
std::optional<std::array<double, 4>> wanted_box(const Call& call) {
  if (!call.parameter("bbox")) return std::nullopt;
  const auto parts = list(call, "bbox");
  std::array<double, 4> box{};
  bool sound = parts.size() == 4;
  for (std::size_t i = 0; sound && i < 4; ++i) {
    const char* last = parts[i].data() + parts[i].size();
    const auto [end, error] = std::from_chars(parts[i].data(), last, box[i]);
    sound = error == std::errc{} && end == last && std::isfinite(box[i]);
  }
  if (!sound || box[1] > box[3]) {
    throw Problem(Failure::invalid_parameter, "bbox is '" + *call.parameter("bbox") +
                                                  "': give west,south,east,north in degrees");
  }
  return box;
}

bool overlap(const std::array<double, 4>& a, const std::array<double, 4>& b) {
  return a[0] <= b[2] && b[0] <= a[2] && a[1] <= b[3] && b[1] <= a[3];
}

/// The CRS the coordinates are kept in, where all shown jobs share one.
std::string storage_crs(const Service& service, const Call& call) {
  int common = 0;
  for (const auto& job : shown_jobs(service, call)) {
    const int epsg = epsg_of(service.store, job);
    if (common != 0 && common != epsg) return crs84;
    common = epsg;
  }
  if (common == 0) return crs84;
  return "http://www.opengis.net/def/crs/EPSG/0/" + std::to_string(common);
}

json collection_document(const Service& service, const Call& call, Collection collection) {
  const std::string own = service.url + "/collections/" + to_string(collection);
  std::array<double, 4> box{-180, -90, 180, 90};
  const auto features = all_features(service, call, collection);
  for (std::size_t i = 0; i < features.size(); ++i) {
    const auto one = box_of(features[i]);
    box = i == 0 ? one
                 : std::array{std::min(box[0], one[0]), std::min(box[1], one[1]),
                              std::max(box[2], one[2]), std::max(box[3], one[3])};
  }
  const char* title = collection == Collection::sections        ? "Sections"
                      : collection == Collection::release_zones ? "Release zones"
                                                                : "Runout zones";
  return {{"id", to_string(collection)},
          {"title", title},
          {"itemType", "feature"},
          {"crs", {crs84}},
          {"storageCrs", storage_crs(service, call)},
          {"extent", {{"spatial", {{"bbox", json::array({box})}, {"crs", crs84}}}}},
          {"links",
           {{{"href", own}, {"rel", "self"}, {"type", "application/json"}},
            {{"href", own + "/items"}, {"rel", "items"}, {"type", "application/geo+json"}}}}};
}

Answer geojson_answer(const json& document) {
  Answer answer = json_answer(document);
  answer.type = "application/geo+json";
  return answer;
}

}  // namespace

Answer get_collections(Service& service, const Call& call) {
  format(call, {"json"});
  json collections = json::array();
  for (const Collection collection : all_collections) {
    collections.push_back(collection_document(service, call, collection));
  }
  return json_answer({{"collections", collections},
                      {"links",
                       {{{"href", service.url + "/collections"},
                         {"rel", "self"},
                         {"type", "application/json"}}}}});
}

Answer get_collection(Service& service, const Call& call) {
  format(call, {"json"});
  return json_answer(collection_document(service, call, collection_or_problem(call.captured[0])));
}

Answer get_items(Service& service, const Call& call) {
  format(call, {"json", "geojson"});
  const Collection collection = collection_or_problem(call.captured[0]);
  const int limit = whole_number(call, "limit", 100, 1, 10'000);
  const int offset = whole_number(call, "offset", 0, 0, 1'000'000'000);
  auto features = all_features(service, call, collection);
  if (const auto box = wanted_box(call)) {
    std::erase_if(features, [&](const json& feature) { return !overlap(box_of(feature), *box); });
  }
  const auto matched = static_cast<int>(features.size());
  const int from = std::min(offset, matched);
  const int to = std::min(from + limit, matched);
  json document = feature_collection({features.begin() + from, features.begin() + to});
  const std::string own = service.url + "/collections/" + to_string(collection) + "/items";
  document["links"] = json::array({{{"href", with_offset(call, own, offset)},
                                    {"rel", "self"},
                                    {"type", "application/geo+json"}}});
  if (to < matched) {
    document["links"].push_back(
        {{"href", with_offset(call, own, to)}, {"rel", "next"}, {"type", "application/geo+json"}});
  }
  document["numberMatched"] = matched;
  document["numberReturned"] = to - from;
  document["timeStamp"] = db::utc_now();
  return geojson_answer(document);
}

Answer get_item(Service& service, const Call& call) {
  format(call, {"json", "geojson"});
  const Collection collection = collection_or_problem(call.captured[0]);
  for (auto& feature : all_features(service, call, collection)) {
    if (std::to_string(feature["id"].get<std::int64_t>()) != call.captured[1]) continue;
    feature["links"] =
        json::array({{{"href", service.url + "/collections/" + to_string(collection) + "/items/" +
                                   call.captured[1]},
                      {"rel", "self"},
                      {"type", "application/geo+json"}},
                     {{"href", service.url + "/collections/" + to_string(collection)},
                      {"rel", "collection"},
                      {"type", "application/json"}}});
    return geojson_answer(feature);
  }
  throw Problem(Failure::no_such_resource,
                "there is no feature " + call.captured[1] + " in " + to_string(collection));
}

}  // namespace leda::server
