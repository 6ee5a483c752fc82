#pragma once
// Sections and zones as GeoJSON features in longitude and latitude (CRS84), for OGC API - Features
// and for results. Clients infer the schema from the first page, so every property stands on every
// feature; its type is told by schema_of as well.

#include <array>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "db/store.hpp"

namespace leda::server {

enum class Collection { sections, release_zones, runout_zones, probability_zones };

inline constexpr std::array all_collections{Collection::sections, Collection::release_zones,
                                            Collection::runout_zones,
                                            Collection::probability_zones};

const char* to_string(Collection collection);
std::optional<Collection> collection_from(const std::string& id);

/// Calls `use` with each feature of a page: as JSON a page takes twenty times its text. Where
/// `filter` names a job, the job must have a DEM.
void for_each_feature(const db::Store& store, Collection collection, const db::PageFilter& filter,
                      const std::function<void(nlohmann::json&&)>& use);

/// How many features a filter finds, over all pages.
int count_features(const db::Store& store, Collection collection, const db::PageFilter& filter);

/// What the features of a collection cover.
db::Coverage coverage_of(const db::Store& store, Collection collection);

/// JSON schema of a feature's properties.
nlohmann::json schema_of(Collection collection);

/// Keeps where the sections of a job lie, so that pages find them by box. Needed after a layout; a
/// job without a DEM is left alone. What cannot be placed is told in the log.
void keep_section_boxes(db::Store& store, const db::JobStatus& job);
/// The same of its zones, after they were stored.
void keep_zone_boxes(db::Store& store, const db::JobStatus& job);

}  // namespace leda::server
