#pragma once
// A job of the store as layers of a map.

#include <string>

#include "db/store.hpp"
#include "profiles/export_layers.hpp"

namespace leda::server {

/// @throws Problem wrong_state where the job has no map (no DEM)
profiles::RegionLayers region_layers(const db::Store& store, const db::JobStatus& job);

profiles::SectionFeature section_feature(const db::SectionRecord& section);

/// EPSG code of the job's DEM; 0 where it has none.
int epsg_of(const db::Store& store, const db::JobStatus& job);

}  // namespace leda::server
