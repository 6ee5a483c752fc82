#include "server/documents/soil_reader.hpp"

#include <fmt/format.h>

#include <cmath>

#include "server/documents/rate_names.hpp"
#include "server/documents/softening_names.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

Strength read_strength_table(const json& value, const std::string& at, FaultList& faults) {
  Strength strength;
  ObjectReader reader(value, at, faults);
  const json* depth = reader.find("at_depth_m");
  const json* elevation = reader.find("at_elevation_m");
  reader.refuse_unknown();
  if ((depth == nullptr) == (elevation == nullptr)) {
    faults.add(at, "must have exactly one of at_depth_m and at_elevation_m");
    return strength;
  }
  strength.by = depth ? Strength::By::depth : Strength::By::elevation;
  const std::string table_at = reader.at(depth ? "at_depth_m" : "at_elevation_m");
  const json& table = depth ? *depth : *elevation;
  if (!table.is_array()) {
    faults.add(table_at, "is " + kind_of(table) + ", must be a list of rows [m, kPa]");
    return strength;
  }
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto row =
        read_pair(table[i], fmt::format("{}/{}", table_at, i), "a row [m, kPa]", faults);
    // A row at fault keeps its place, so that the pointers of later ones stay right.
    strength.table.push_back(row ? std::array{(*row)[0], (*row)[1] * kilo}
                                 : std::array<double, 2>{NAN, NAN});
  }
  return strength;
}

Strength read_strength(ObjectReader& material, FaultList& faults) {
  Strength strength;
  const json* value = material.require("peak_strength_kPa");
  if (!value) return strength;
  const std::string at = material.at("peak_strength_kPa");
  if (value->is_object()) return read_strength_table(*value, at, faults);
  if (!value->is_number()) {
    faults.add(at, "is " + kind_of(*value) +
                       ", must be a number or a table {\"at_depth_m\": [[m, kPa], ...]}");
    return strength;
  }
  strength.constant_Pa = read_number(*value, at, faults) * kilo;
  return strength;
}

/// Either modulus may be given. Young's is turned into the shear modulus in kPa, so that a
/// document with the one and a document with the other are the same case to the last bit.
double read_shear_modulus(ObjectReader& reader, double poisson_ratio, ReadMaterials& result,
                          FaultList& faults) {
  const auto shear = reader.optional_number("shear_modulus_kPa");
  const auto youngs = reader.optional_number("youngs_modulus_kPa");
  if (!youngs) {
    if (!shear && reader.is_object()) {
      faults.add(reader.at("shear_modulus_kPa"), "is missing: give it or youngs_modulus_kPa");
    }
    return shear.value_or(0) * kilo;
  }
  result.derived.insert(reader.at("shear_modulus_kPa"));
  if (shear) {
    faults.add(reader.at("youngs_modulus_kPa"),
               "is given beside shear_modulus_kPa: give one of the two");
  }
  faults.positive(reader.at("youngs_modulus_kPa"), *youngs, "kPa");
  return *youngs / (2 * (1 + poisson_ratio)) * kilo;
}

/// Nothing where the law is not known: what its members mean is not known either.
std::optional<Softening> read_softening(const json& value, const std::string& at,
                                        FaultList& faults) {
  Softening softening;
  ObjectReader reader(value, at, faults);
  const std::string law = reader.text("law");
  if (const SofteningName* name = softening_named(law)) {
    softening.law = name->read(reader);
  } else if (!law.empty()) {
    faults.add(reader.at("law"), "is \"" + law + "\", must be one of " + softening_names());
  }
  softening.reference_size_m = reader.number_or("reference_size_m", softening.reference_size_m);
  if (reader.find("regularization")) {
    const std::string text = reader.text("regularization");
    if (const auto regularization = regularization_named(text)) {
      softening.regularization = *regularization;
    } else if (!text.empty()) {
      faults.add(reader.at("regularization"),
                 "is \"" + text + "\", must be one of beta, whole-curve, band, none");
    }
  }
  if (softening.regularization == Regularization::band) {
    softening.band_m = reader.number("band_m");
  } else if (reader.find("band_m")) {
    faults.add(reader.at("band_m"), "is given without \"regularization\": \"band\"");
    reader.number("band_m");
  }
  if (!softening_named(law)) return std::nullopt;
  reader.refuse_unknown();
  return softening;
}

// The law of the strength above the remolded one, and in it that of the remolded strength.
void read_rates(const json& value, const std::string& at, Material& m, FaultList& faults) {
  m.rate = read_rate(value, at, faults, "remolded");
  if (value.is_object() && value.contains("remolded")) {
    m.remolded_rate = read_rate(value.at("remolded"), at + "/remolded", faults);
  }
}

RandomField read_random_field(const json& value, const std::string& at, FaultList& faults) {
  RandomField field;
  ObjectReader reader(value, at, faults);
  field.cov = reader.number("cov");
  field.horizontal_m = reader.number("horizontal_m");
  field.vertical_m = reader.number("vertical_m");
  reader.refuse_unknown();
  return field;
}

bool read_drains(ObjectReader& reader, FaultList& faults) {
  if (!reader.find("drainage")) return false;
  const std::string text = reader.text("drainage");
  if (text != "drained" && text != "undrained" && !text.empty()) {
    faults.add(reader.at("drainage"), "is \"" + text + "\", must be undrained or drained");
  }
  return text == "drained";
}

Material read_material(const json& value, const std::string& at, ReadMaterials& result,
                       FaultList& faults) {
  Material m;
  ObjectReader reader(value, at, faults);
  m.unit_weight = reader.number("unit_weight_kN_m3") * kilo;
  m.poisson_ratio = reader.number("poisson_ratio");
  m.shear_modulus_Pa = read_shear_modulus(reader, m.poisson_ratio, result, faults);
  m.peak_strength = read_strength(reader, faults);
  m.k0 = reader.number_or("k0", m.k0);
  if (const json* drained = reader.find("drained")) {
    ObjectReader part(*drained, reader.at("drained"), faults);
    DrainedStrength strength;
    strength.cohesion_Pa = part.number("cohesion_kPa") * kilo;
    strength.friction_angle_deg = part.number("friction_angle_deg");
    m.drained = strength;
    part.refuse_unknown();
  }
  m.drains = read_drains(reader, faults);
  if (const json* softening = reader.find("softening")) {
    m.softening = read_softening(*softening, reader.at("softening"), faults);
  }
  if (const json* rate = reader.find("rate")) {
    read_rates(*rate, reader.at("rate"), m, faults);
  }
  if (reader.find("tensile_strength_kPa")) {
    m.tensile_strength_Pa = reader.number("tensile_strength_kPa") * kilo;
  }
  if (const json* flow = reader.find("flow")) {
    m.flow = read_flow(*flow, reader.at("flow"), faults);
  }
  if (const json* field = reader.find("field")) {
    m.field = read_random_field(*field, reader.at("field"), faults);
  }
  reader.refuse_unknown();
  return m;
}

Layer read_layer(const json& value, const std::string& at, FaultList& faults) {
  Layer layer;
  ObjectReader reader(value, at, faults);
  layer.material = reader.text("material");
  layer.thickness_m = reader.optional_number("thickness_m");
  layer.bottom_m = reader.optional_number("bottom_m");
  layer.bottom_below_toe_m = reader.optional_number("bottom_below_toe_m");
  if (const json* line = reader.find("bottom")) {
    layer.bottom = read_polyline(*line, reader.at("bottom"), faults);
  }
  reader.refuse_unknown();
  return layer;
}

}  // namespace

ReadMaterials read_materials(const json& value, const std::string& at, FaultList& faults) {
  ReadMaterials result;
  ObjectReader reader(value, at, faults);
  if (!reader.is_object()) return result;
  for (const auto& member : value.items()) {
    // The name is checked as a text too: it comes back in messages and tables.
    read_text(member.key(), reader.at(member.key()), 100, faults);
    result.materials[member.key()] =
        read_material(member.value(), reader.at(member.key()), result, faults);
  }
  return result;
}

std::vector<Layer> read_layers(const json& value, const std::string& at, FaultList& faults) {
  std::vector<Layer> layers;
  if (!value.is_array()) {
    faults.add(at, "is " + kind_of(value) + ", must be a list of layers, top down");
    return layers;
  }
  for (std::size_t i = 0; i < value.size(); ++i) {
    layers.push_back(read_layer(value[i], fmt::format("{}/{}", at, i), faults));
  }
  return layers;
}

std::vector<SoilColumn> read_columns(const json& value, const std::string& at, FaultList& faults) {
  std::vector<SoilColumn> columns;
  if (!value.is_array() || value.empty()) {
    faults.add(at, (value.is_array() ? "is an empty list" : "is " + kind_of(value)) +
                       std::string(", must be a list of columns, left to right"));
    return columns;
  }
  for (std::size_t i = 0; i < value.size(); ++i) {
    ObjectReader reader(value[i], fmt::format("{}/{}", at, i), faults);
    SoilColumn& column = columns.emplace_back();
    column.from_m = reader.number("from_m");
    column.to_m = reader.number("to_m");
    if (const json* v = reader.require("layers")) {
      column.layers = read_layers(*v, reader.at("layers"), faults);
    }
    reader.refuse_unknown();
  }
  return columns;
}

WaterTable read_water_table(const json& value, const std::string& at, FaultList& faults) {
  WaterTable water;
  ObjectReader reader(value, at, faults);
  water.depth_m = reader.optional_number("depth_m");
  if (const json* line = reader.find("line")) {
    water.line = read_polyline(*line, reader.at("line"), faults);
  }
  reader.refuse_unknown();
  return water;
}

}  // namespace leda::server
