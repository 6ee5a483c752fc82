#pragma once
// The fields of the exported layers, one table each. Private to profiles/.

#include <ogr_feature.h>

#include <functional>
#include <vector>

#include "profiles/export_layers.hpp"

namespace leda::profiles {

/// One point of a section's ground, on the map.
struct ProfilePoint {
  const SectionFeature* section = nullptr;
  const char* stage = "";  ///< "before" or "after"
  double x_m = 0;
  double elevation_m = 0;
  MapPoint where;
};

/// Texts go out whole.
inline constexpr std::size_t any_length = static_cast<std::size_t>(-1);

struct ZoneRow {
  const Zone* zone = nullptr;
  double area_m2 = 0;
};

template <class Row>
struct Column {
  const char* name;
  const char* short_name;  ///< for shapefiles: 10 characters
  OGRFieldType type;
  std::function<void(OGRFeature&, int, const Row&)> set;  ///< leaves the field alone: no value
};

std::vector<Column<SectionFeature>> section_columns(const RegionLayers& layers,
                                                    std::size_t most_bytes = any_length);
std::vector<Column<ProfilePoint>> profile_columns(const RegionLayers& layers);
/// @param of_ensemble with what zones of an ensemble have beside
std::vector<Column<ZoneRow>> zone_columns(const RegionLayers& layers, bool of_ensemble,
                                          std::size_t most_bytes = any_length);

}  // namespace leda::profiles
