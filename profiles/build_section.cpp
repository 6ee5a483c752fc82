#include "profiles/build_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "profiles/place_result.hpp"
#include "profiles/soil_along.hpp"
#include "solver/section/fault_list.hpp"

namespace leda::profiles {
namespace {

constexpr double least_difference_of_bases_m = 0.01;

double lowest(const Polyline& ground) {
  return std::min_element(ground.begin(), ground.end(),
                          [](const Point& a, const Point& b) { return a.z < b.z; })
      ->z;
}

void check_layers(const SoilModel& model, const std::string& at, std::vector<Fault>& faults) {
  if (model.layers.empty()) {
    faults.push_back({at + "/layers", "is empty: at least one layer must reach the base"});
    return;
  }
  for (std::size_t i = 0; i < model.layers.size(); ++i) {
    const Layer& layer = model.layers[i];
    const std::string pointer = fmt::format("{}/layers/{}", at, i);
    if (!model.materials.contains(layer.material)) {
      faults.push_back({pointer + "/material",
                        "'" + layer.material + "' is not among the materials of this soil model"});
    }
    if (!layer.bottom.empty()) {
      faults.push_back({pointer + "/bottom",
                        "is a line along one section, a region has many: use thickness_m, bottom_m "
                        "or bottom_below_toe_m"});
    }
    const bool ends = layer.thickness_m || layer.bottom_m || layer.bottom_below_toe_m;
    if (!ends && i + 1 < model.layers.size()) {
      faults.push_back({pointer,
                        "has no end, the layers below it would be empty: give "
                        "thickness_m, bottom_m or bottom_below_toe_m"});
    }
  }
}

void check_base(const SoilModel& model, const Profile& profile, double base_m,
                const std::string& at, std::vector<Fault>& faults) {
  const double ground_m = lowest(profile.ground);
  const std::string pointer = at + (model.base_m ? "/base_m" : "/base_below_toe_m");
  if (!model.base_m && !(model.base_below_toe_m > 0)) {
    faults.push_back(
        {pointer, fmt::format("is {:g}, it must be positive", model.base_below_toe_m)});
  } else if (!std::isfinite(base_m) || base_m >= ground_m) {
    faults.push_back(
        {pointer, fmt::format("puts the base at {:.2f} m, above the lowest ground of section {} at "
                              "{:.2f} m: it must lie below it",
                              base_m, profile.section, ground_m)});
  }
}

constexpr std::size_t longest_name = 100;  // that a case file takes

/// Adds the materials of a model; a name that another model has already is told apart by the
/// model's own. @return the names in the section by those in the model
std::map<std::string, std::string> add_materials(const SoilModel& model, std::size_t index,
                                                 BuiltSection& built) {
  std::map<std::string, std::string> names;
  for (const auto& [name, material] : model.materials) {
    std::string unique = name;
    if (built.materials.contains(name)) {
      unique = fmt::format("{} ({})", name, model.name);
      if (unique.size() > longest_name) unique = fmt::format("{} ({})", name, index + 1);
    }
    names[name] = unique;
    built.section.materials[unique] = material;
    built.materials[unique] = {index, "/materials/" + pointer_part(name)};
  }
  return names;
}

void add_columns(const std::vector<SoilPart>& parts, const std::vector<SoilModel>& soil,
                 BuiltSection& built) {
  std::map<std::size_t, std::map<std::string, std::string>> names;
  for (const SoilPart& part : parts) {
    const SoilModel& model = soil[part.model];
    if (!names.contains(part.model)) {
      names[part.model] = add_materials(model, part.model, built);
    }
    SoilColumn column{part.from_m, part.to_m, model.layers};
    for (Layer& layer : column.layers) layer.material = names[part.model].at(layer.material);
    built.section.columns.push_back(std::move(column));
    built.column_models.push_back(part.model);
  }
}

/// The water of each part as one line of elevations; nothing where all are dry.
std::optional<WaterTable> water_along(const Profile& profile, const std::vector<SoilPart>& parts,
                                      const std::vector<SoilModel>& soil, double base_m) {
  const auto depth = [&](const SoilPart& part) -> std::optional<double> {
    const auto& water = soil[part.model].water_table;
    return water ? water->depth_m : std::nullopt;
  };
  const bool same = std::ranges::all_of(
      parts, [&](const SoilPart& part) { return depth(part) == depth(parts.front()); });
  if (same) return soil[parts.front().model].water_table;
  WaterTable water;
  for (const SoilPart& part : parts) {
    const auto level = [&](double ground) {
      const auto below = depth(part);
      return below ? ground - *below : base_m;
    };
    water.line.push_back({part.from_m, level(elevation_at(profile.ground, part.from_m))});
    for (const Point& p : profile.ground) {
      if (p.x > part.from_m && p.x < part.to_m) water.line.push_back({p.x, level(p.z)});
    }
    water.line.push_back({part.to_m, level(elevation_at(profile.ground, part.to_m))});
  }
  return water;
}

double base_of(const SoilModel& model, const Profile& profile) {
  const double bottom = std::min(profile.bank.toe.z, lowest(profile.ground));
  return model.base_m.value_or(bottom - model.base_below_toe_m);
}

void check_model(const SoilModel& model, const std::string& at, std::vector<Fault>& faults) {
  check_layers(model, at, faults);
  if (model.water_table && !model.water_table->line.empty()) {
    faults.push_back(
        {at + "/water_table/line", "is a line along one section, a region has many: use depth_m"});
  }
}

void warn_of_other_bases(const Profile& profile, const std::vector<SoilModel>& soil,
                         BuiltSection& built) {
  std::set<std::size_t> others(built.column_models.begin(), built.column_models.end());
  others.erase(built.soil_model);
  for (const std::size_t other : others) {
    const double base_m = base_of(soil[other], profile);
    if (std::abs(base_m - built.section.base_m) < least_difference_of_bases_m) continue;
    built.warnings.push_back(
        fmt::format("the base is that of soil '{}' at the crest, {:.2f} m, for the whole section; "
                    "soil '{}' has "
                    "it at {:.2f} m",
                    soil[built.soil_model].name, built.section.base_m, soil[other].name, base_m));
  }
}

void add_soils(const Profile& profile, const std::vector<SoilPart>& parts,
               const std::vector<SoilModel>& soil, BuiltSection& built) {
  Section& section = built.section;
  if (parts.size() == 1) {
    section.layers = soil[built.soil_model].layers;
    add_materials(soil[built.soil_model], built.soil_model, built);
  } else {
    add_columns(parts, soil, built);
  }
  section.water_table = water_along(profile, parts, soil, section.base_m);
  built.warnings = warnings_of_soils(profile, soil);
  warn_of_other_bases(profile, soil, built);
}

}  // namespace

BuiltSection build_section(const Profile& profile, const std::vector<SoilModel>& soil) {
  BuiltSection built;
  const MapPoint crest = point_on_trace(profile, profile.bank.crest.x);
  const auto index = model_at(crest, soil);
  if (!index) {
    built.faults.push_back(
        {"", fmt::format("no soil model applies at the crest of section {} ({:.2f}, {:.2f}): give "
                         "one without a polygon, or one whose polygon holds it",
                         profile.section, crest.x, crest.y)});
    return built;
  }
  built.soil_model = *index;
  Section& section = built.section;
  section.name = profile.section;
  section.ground = profile.ground;
  section.base_m = base_of(soil[*index], profile);
  section.crest = profile.bank.crest;
  section.toe = profile.bank.toe;
  std::vector<SoilPart> parts = soil_parts(profile, soil);
  // The soil at the crest holds for the whole section where the others are slivers.
  if (parts.size() <= 1) parts = {{profile.ground.front().x, profile.ground.back().x, *index}};
  std::set<std::size_t> models;
  for (const SoilPart& part : parts) models.insert(part.model);
  for (const std::size_t model : models) {
    check_model(soil[model], fmt::format("/{}", model), built.faults);
  }
  check_base(soil[*index], profile, section.base_m, fmt::format("/{}", *index), built.faults);
  if (built.faults.empty()) add_soils(profile, parts, soil, built);
  return built;
}

SoilOrigin origin_of(const BuiltSection& built, const std::string& pointer) {
  constexpr std::string_view columns = "/columns/";
  if (pointer.starts_with(columns)) {
    const std::size_t rest = pointer.find('/', columns.size());
    const std::size_t column = std::stoul(pointer.substr(columns.size()));
    return {built.column_models[column], rest == std::string::npos ? "" : pointer.substr(rest)};
  }
  for (const auto& [name, origin] : built.materials) {
    const std::string at = "/materials/" + pointer_part(name);
    if (pointer != at && !pointer.starts_with(at + "/")) continue;
    return {origin.model, origin.pointer + pointer.substr(at.size())};
  }
  return {built.soil_model, pointer};
}

}  // namespace leda::profiles
