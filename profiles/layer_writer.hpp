#pragma once
// Layers to a vector dataset of OGR. Private to profiles/.

#include <filesystem>
#include <string>
#include <vector>

#include "profiles/export_layers.hpp"

namespace leda::profiles {

/// The layers in the order they are written; probability zones where there was an ensemble.
std::vector<std::string> layers_of(const RegionLayers& layers);

/// One GeoPackage with every layer and its styles.
void write_geopackage(const RegionLayers& layers, const std::filesystem::path& file);

/// One GeoJSON collection in CRS84 of sections and zones (profiles have too many points).
void write_geojson(const RegionLayers& layers, const std::filesystem::path& file);

/// One file a layer in `folder`; ending "shp" or "fgb".
void write_layer_files(const RegionLayers& layers, const std::string& ending,
                       const std::filesystem::path& folder);

}  // namespace leda::profiles
