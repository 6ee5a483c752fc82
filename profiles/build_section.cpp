#include "profiles/build_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "profiles/place_result.hpp"
#include "profiles/soil_along.hpp"

namespace leda::profiles {
namespace {

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
  const SoilModel& model = soil[*index];
  const std::string at = fmt::format("/{}", *index);
  const double bottom = std::min(profile.bank.toe.z, lowest(profile.ground));
  const double base_m = model.base_m.value_or(bottom - model.base_below_toe_m);
  check_layers(model, at, built.faults);
  check_base(model, profile, base_m, at, built.faults);
  if (model.water_table && !model.water_table->line.empty()) {
    built.faults.push_back(
        {at + "/water_table/line", "is a line along one section, a region has many: use depth_m"});
  }

  Section& section = built.section;
  section.name = profile.section;
  section.ground = profile.ground;
  section.base_m = base_m;
  section.water_table = model.water_table;
  section.layers = model.layers;
  section.materials = model.materials;
  section.crest = profile.bank.crest;
  section.toe = profile.bank.toe;
  built.warnings = warnings_of_soils(profile, soil, *index);
  return built;
}

}  // namespace leda::profiles
