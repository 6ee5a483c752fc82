#include <fmt/format.h>

#include "server/documents/map_shape.hpp"
#include "server/documents/region_readers.hpp"
#include "server/documents/soil_reader.hpp"
#include "solver/section/validate_section.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

constexpr std::size_t most_models = 100;

/// What a line over x of one section could mean on a map, nobody knows.
void refuse_section_lines(const SoilModel& model, const std::string& at, FaultList& faults) {
  for (std::size_t i = 0; i < model.layers.size(); ++i) {
    if (model.layers[i].bottom.empty()) continue;
    faults.add(fmt::format("{}/layers/{}/bottom", at, i),
               "is a line over one section, must be thickness_m, bottom_m or bottom_below_toe_m in "
               "a region");
  }
  if (model.water_table && !model.water_table->line.empty()) {
    faults.add(at + "/water_table/line", "is a line over one section, must be depth_m in a region");
  }
}

/// Faults of values that could be read.
std::vector<Fault> meaning_of(const SoilModel& model, const std::string& at,
                              const std::set<std::string>& derived) {
  FaultList list;
  check_layers(model.layers, model.materials, at + "/layers", list);
  std::vector<Fault> found = list.take();
  for (Fault& f : validate_materials(model.materials, at + "/materials")) {
    if (!derived.contains(f.pointer)) found.push_back(std::move(f));
  }
  FaultList rest;
  if (!(model.base_below_toe_m > 0))
    rest.positive(at + "/base_below_toe_m", model.base_below_toe_m, "m");
  if (model.water_table && model.water_table->depth_m) {
    const double depth = *model.water_table->depth_m;
    rest.within(at + "/water_table/depth_m", depth, depth >= 0,
                "at least 0 m: standing water is not modelled");
  }
  for (Fault& f : rest.take()) found.push_back(std::move(f));
  return found;
}

void read_where(ObjectReader& reader, std::size_t& points_left, SoilModel& model,
                FaultList& faults) {
  const json* where = reader.find("where");
  if (!where) return;
  const std::string at = reader.at("where");
  if (!where->is_array() || where->empty()) {
    faults.add(at, (where->is_array() ? "is an empty list" : "is " + kind_of(*where)) +
                       std::string(", must be a list of polygons, each a list of [x, y]"));
    model.where.emplace_back();  // it was not meant to apply everywhere
    return;
  }
  for (std::size_t i = 0; i < where->size(); ++i) {
    const std::string polygon = fmt::format("{}/{}", at, i);
    model.where.push_back(read_map_polygon((*where)[i], polygon, points_left, faults));
    points_left -= std::min(points_left, model.where.back().outer.size());
  }
}

void read_base(ObjectReader& reader, SoilModel& model, FaultList& faults) {
  model.base_m = reader.optional_number("base_m");
  const auto below_toe = reader.optional_number("base_below_toe_m");
  if (below_toe) model.base_below_toe_m = *below_toe;
  if (model.base_m && below_toe) {
    faults.add(reader.at("base_below_toe_m"), "is given beside base_m: give one of the two");
  }
}

SoilModel read_model(ObjectReader& reader, const std::string& at, std::vector<Fault>& meaning,
                     FaultList& faults) {
  SoilModel model;
  std::set<std::string> derived;
  if (const json* v = reader.require("layers")) {
    model.layers = read_layers(*v, reader.at("layers"), faults);
  }
  if (const json* v = reader.require("materials")) {
    ReadMaterials read = read_materials(*v, reader.at("materials"), faults);
    model.materials = std::move(read.materials);
    derived = std::move(read.derived);
  }
  if (const json* v = reader.find("water_table")) {
    const std::string water_at = reader.at("water_table");
    model.water_table = read_water_table(*v, water_at, faults);
    if (v->is_object() && !model.water_table->depth_m && model.water_table->line.empty()) {
      faults.add(water_at + "/depth_m", "is missing");
    }
  }
  read_base(reader, model, faults);
  refuse_section_lines(model, at, faults);
  for (Fault& f : meaning_of(model, at, derived)) meaning.push_back(std::move(f));
  return model;
}

void check_models(const std::vector<SoilModel>& models, const std::string& at, FaultList& faults) {
  std::set<std::string> names;
  bool everywhere = false;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const std::string model = fmt::format("{}/{}", at, i);
    if (!models[i].name.empty() && !names.insert(models[i].name).second) {
      faults.add(model + "/name", "is \"" + models[i].name + "\", which another model has already");
    }
    if (models[i].where.empty() && everywhere) {
      faults.add(model, "has no where, and another model applies everywhere already");
    }
    everywhere = everywhere || models[i].where.empty();
  }
}

}  // namespace

ReadSoil read_soil(const json& value, const std::string& at, const RegionLimits& limits,
                   FaultList& faults) {
  ReadSoil soil;
  ObjectReader reader(value, at, faults);
  if (!value.is_object() || !value.contains("models")) {
    soil.models.push_back(read_model(reader, at, soil.meaning, faults));
    reader.refuse_unknown();
    return soil;
  }
  const json& models = *reader.find("models");
  const std::string models_at = reader.at("models");
  reader.refuse_unknown();
  if (!models.is_array() || models.empty() || models.size() > most_models) {
    faults.add(models_at, fmt::format("is {}, must be a list of 1 to {} models",
                                      models.is_array() ? fmt::format("a list of {}", models.size())
                                                        : kind_of(models),
                                      most_models));
    return soil;
  }
  std::size_t points_left = limits.most_line_points;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const std::string model_at = fmt::format("{}/{}", models_at, i);
    ObjectReader model(models[i], model_at, faults);
    std::string name = model.text("name", 100);
    soil.models.push_back(read_model(model, model_at, soil.meaning, faults));
    soil.models.back().name = std::move(name);
    read_where(model, points_left, soil.models.back(), faults);
    model.refuse_unknown();
  }
  check_models(soil.models, models_at, faults);
  return soil;
}

}  // namespace leda::server
