#pragma once
// Layers, materials and water of a case or a region. The units at the edge (kPa, kN/m3) become SI
// here and nowhere else.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "server/documents/object_reader.hpp"
#include "solver/section/section.hpp"

namespace leda::server {

inline constexpr double kilo = 1000;  ///< Pa in a kPa, N in a kN

struct ReadMaterials {
  std::map<std::string, Material> materials;
  /// Pointers of shear moduli that were worked out from Young's moduli: no member of the document.
  std::set<std::string> derived;
};

ReadMaterials read_materials(const nlohmann::json& value, const std::string& at, FaultList& faults);

std::vector<Layer> read_layers(const nlohmann::json& value, const std::string& at,
                               FaultList& faults);

/// Columns of a case file, each with its layers.
std::vector<SoilColumn> read_columns(const nlohmann::json& value, const std::string& at,
                                     FaultList& faults);

WaterTable read_water_table(const nlohmann::json& value, const std::string& at, FaultList& faults);

}  // namespace leda::server
