#pragma once
// How probable it is that ground is reached, over a region: rasters made from the members of a job.

#include <filesystem>
#include <optional>
#include <string>

#include "db/store.hpp"
#include "profiles/map/zone.hpp"
#include "server/operate/data_folder.hpp"

namespace leda::server {

/// "release_probability.tif", "runout_probability.tif"
std::string raster_name(ZoneKind kind);
/// Of a raster, or of its style beside it, with the ending .qml.
std::optional<ZoneKind> raster_kind_from(const std::string& name);

/// Writes a raster and its style.
/// @throws Problem where the job has no ensemble or no map
void write_probability_raster(const DataFolder& data, const db::Store& store,
                              const db::JobStatus& job, ZoneKind kind,
                              const std::filesystem::path& file);

}  // namespace leda::server
