// A case back to its document: the counterpart of soil_reader.cpp.
#include "server/documents/case_file.hpp"
#include "server/documents/rate_names.hpp"
#include "server/documents/settings_reader.hpp"
#include "server/documents/softening_names.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

json to_document(const Polyline& line) {
  json out = json::array();
  for (const Point& p : line) out.push_back({p.x, p.z});
  return out;
}

json to_document(const Strength& strength) {
  if (strength.by == Strength::By::constant) return per_kilo(strength.constant_Pa);
  json rows = json::array();
  for (const auto& [where, value] : strength.table) rows.push_back({where, per_kilo(value)});
  return {{strength.by == Strength::By::depth ? "at_depth_m" : "at_elevation_m", rows}};
}

json to_document(const Material& m) {
  json out{{"unit_weight_kN_m3", per_kilo(m.unit_weight)},
           {"shear_modulus_kPa", per_kilo(m.shear_modulus_Pa)},
           {"poisson_ratio", m.poisson_ratio},
           {"peak_strength_kPa", to_document(m.peak_strength)},
           {"k0", m.k0}};
  if (m.drained) {
    out["drained"] = {{"cohesion_kPa", per_kilo(m.drained->cohesion_Pa)},
                      {"friction_angle_deg", m.drained->friction_angle_deg}};
  }
  if (m.drains) out["drainage"] = "drained";
  if (m.softening) out["softening"] = leda::server::to_document(*m.softening);
  if (m.rate) out["rate"] = leda::server::to_document(*m.rate);
  if (m.remolded_rate) out["rate"]["remolded"] = leda::server::to_document(*m.remolded_rate);
  if (m.tensile_strength_Pa) out["tensile_strength_kPa"] = per_kilo(*m.tensile_strength_Pa);
  if (m.flow) out["flow"] = leda::server::to_document(*m.flow);
  if (m.field) {
    out["field"] = {{"cov", m.field->cov},
                    {"horizontal_m", m.field->horizontal_m},
                    {"vertical_m", m.field->vertical_m}};
  }
  return out;
}

json to_document(const Layer& layer) {
  json out{{"material", layer.material}};
  if (layer.thickness_m) out["thickness_m"] = *layer.thickness_m;
  if (layer.bottom_m) out["bottom_m"] = *layer.bottom_m;
  if (layer.bottom_below_toe_m) out["bottom_below_toe_m"] = *layer.bottom_below_toe_m;
  if (!layer.bottom.empty()) out["bottom"] = to_document(layer.bottom);
  return out;
}

json to_document(const std::vector<Layer>& layers) {
  json out = json::array();
  for (const Layer& layer : layers) out.push_back(to_document(layer));
  return out;
}

}  // namespace

json to_document(const CaseFile& case_file) {
  const Section& section = case_file.section;
  json out{{"name", section.name},
           {"ground", to_document(section.ground)},
           {"base_m", section.base_m},
           {"materials", json::object()}};
  if (section.water_table) {
    const WaterTable& water = *section.water_table;
    out["water_table"] =
        water.depth_m ? json{{"depth_m", *water.depth_m}} : json{{"line", to_document(water.line)}};
  }
  if (section.columns.empty()) out["layers"] = to_document(section.layers);
  for (const SoilColumn& column : section.columns) {
    out["columns"].push_back(
        {{"from_m", column.from_m}, {"to_m", column.to_m}, {"layers", to_document(column.layers)}});
  }
  for (const auto& [name, m] : section.materials) out["materials"][name] = to_document(m);
  if (section.crest) out["crest_m"] = {section.crest->x, section.crest->z};
  if (section.toe) out["toe_m"] = {section.toe->x, section.toe->z};
  write_settings(case_file.settings, out);
  return out;
}

}  // namespace leda::server
