#pragma once
// Sections and zones as GeoJSON features in longitude and latitude (CRS84), for OGC API - Features
// and for results. Clients infer the schema from the first page, so every property stands on every
// feature.

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "db/store.hpp"

namespace leda::server {

enum class Collection { sections, release_zones, runout_zones };

inline constexpr std::array all_collections{Collection::sections, Collection::release_zones,
                                            Collection::runout_zones};

const char* to_string(Collection collection);
std::optional<Collection> collection_from(const std::string& id);

/// Every feature of a job in a collection. @pre the job has a DEM
std::vector<nlohmann::json> features_of(const db::Store& store, const db::JobRecord& job,
                                        Collection collection);

/// {west, south, east, north} of a feature's geometry, degrees.
std::array<double, 4> box_of(const nlohmann::json& feature);

nlohmann::json feature_collection(const std::vector<nlohmann::json>& features);

}  // namespace leda::server
