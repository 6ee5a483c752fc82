#pragma once
// One cross-section: its ground, its layers and its water, in (x, z), metres.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "solver/section/geometry.hpp"
#include "solver/section/material.hpp"

namespace leda {

/// A layer ends at exactly one of these; a layer with none of them reaches the base.
struct Layer {
  std::string material;
  std::optional<double> thickness_m;  ///< measured from the ground down to the layer's bottom
  std::optional<double> bottom_m;     ///< elevation
  std::optional<double> bottom_below_toe_m;  ///< measured down from the section's toe
  Polyline bottom;                           ///< elevations along x
};

/// Ground between two places of a section that differs along it.
struct SoilColumn {
  double from_m = 0, to_m = 0;
  std::vector<Layer> layers;  ///< top down; the last reaches the base
};

/// Either a depth below ground or a line of elevations; u = gamma_w times depth below it.
struct WaterTable {
  std::optional<double> depth_m;
  Polyline line;
};

struct Section {
  std::string name;
  Polyline ground;  ///< left to right
  double base_m = 0;
  std::optional<WaterTable> water_table;  ///< absent: dry
  std::vector<Layer> layers;              ///< top down; the last reaches the base
  std::vector<SoilColumn> columns;        ///< in place of `layers`: left to right, without a gap
  std::map<std::string, Material> materials;
  std::optional<Point> crest;  ///< absent: found by find_crest_and_toe
  std::optional<Point> toe;
};

inline constexpr double water_unit_weight = 9810;  ///< N/m3
inline constexpr double gravity = 9.81;            ///< m/s2

/// Lists of layers of a section: one a column, or the only one.
std::size_t layer_lists(const Section& section);

/// One of them.
/// @param list less than layer_lists()
const std::vector<Layer>& layers_of(const Section& section, std::size_t list);

/// The list in force at x. A border belongs to the column on its right; the outer ones go on.
std::size_t layer_list_at(const Section& section, double x);
const std::vector<Layer>& layers_at(const Section& section, double x);

/// Elevation of the bottom of a layer at x, never below the base and never above the ground.
double layer_bottom(const Section& section, const Layer& layer, double x);

/// The layer that holds a point under ground (the last one at the base).
const Layer& layer_at(const Section& section, Point p);

/// Pore pressure of the water table at a point, Pa, never negative.
double pore_pressure(const Section& section, Point p);

}  // namespace leda
