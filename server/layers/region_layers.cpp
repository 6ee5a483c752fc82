#include "server/layers/region_layers.hpp"

#include <nlohmann/json.hpp>

#include "server/layers/summary.hpp"
#include "server/operate/problem.hpp"

namespace leda::server {
namespace {

void add_result(profiles::SectionFeature& feature, const SectionResult& result) {
  feature.retrogression_m = result.crest_to_crest_retrogression_m;
  feature.runout_m = result.runout_m;
  feature.runout_from_crest_m = result.runout_from_crest_m;
  feature.retrogression_is = to_string(result.retrogression_is);
  feature.runout_is = to_string(result.runout_is);
  feature.slides = result.slides;
  feature.simulated_s = result.simulated_s;
  feature.run_time_s = result.run_time_s;
  feature.ground_after = result.profile_after;
}

std::optional<double> number_at(const nlohmann::json& document, const char* pointer) {
  const nlohmann::json::json_pointer at(pointer);
  if (!document.contains(at) || !document.at(at).is_number()) return {};
  return document.at(at).get<double>();
}

void add_screening(profiles::SectionFeature& feature, const std::string& screening) {
  const auto document = nlohmann::json::parse(screening, nullptr, false);
  if (!document.is_object()) return;
  feature.decision = document.value("decision", "");
  feature.factor_of_safety = number_at(document, "/factor_of_safety/undrained/bishop");
  feature.stability_number = number_at(document, "/stability_number");
}

}  // namespace

profiles::SectionFeature section_feature(const db::SectionRecord& section) {
  profiles::SectionFeature feature;
  feature.name = section.name;
  feature.line = section.line;
  feature.order = section.order;
  feature.trace = section.trace;
  feature.status = status_of(section);
  feature.reason = section.reason;
  add_screening(feature, section.screening);
  feature.ground_before = section.ground;
  feature.warnings = warnings_of(section);
  if (section.result) add_result(feature, *section.result);
  if (section.placed && section.placed->known) {
    feature.crest = section.placed->crest;
    feature.toe = section.placed->toe;
    feature.backscarp = section.placed->backscarp;
    feature.front = section.placed->front;
    feature.made_by = section.placed->made_by;
  }
  return feature;
}

int epsg_of(const db::Store& store, const db::JobStatus& job) {
  if (job.raster.empty()) return 0;
  const auto raster = store.raster(job.raster);
  return raster ? raster->epsg : 0;
}

profiles::RegionLayers region_layers(const db::Store& store, const db::JobStatus& job) {
  profiles::RegionLayers layers;
  layers.name = job.name;
  layers.job = job.id;
  layers.epsg = epsg_of(store, job);
  if (layers.epsg == 0) {
    throw Problem(Failure::wrong_state, "job " + job.id + " has no map: it is a " + job.process);
  }
  const std::string dem = " dem " + store.raster(job.raster)->sha256;
  for (const auto& section : store.sections(job.id)) {
    layers.sections.push_back(section_feature(section));
    auto& made_by = layers.sections.back().made_by;
    if (!made_by.empty()) made_by.insert(0, "case ").append(dem);
  }
  for (const auto& zone : store.zones(job.id)) layers.zones.push_back(zone.zone);
  return layers;
}

}  // namespace leda::server
